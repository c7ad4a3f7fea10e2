#pragma once

#include <vector>

#include "models/describe.h"

namespace touchdown::config {

/// Matrix of a ROS or EuRoC file: a section with rows, cols and data (row-major). `data` is empty if it is absent.
struct ConfigMatrix {
  int rows = 0;
  int cols = 0;
  std::vector<double> data;
};

/// Describes the section of a matrix with the allowed numbers of rows and columns.
void DescribeMatrix(models::ConfigVisitor& v, const models::Key& key, ConfigMatrix& matrix, const models::Range& rows,
                    const models::Range& cols);

}  // namespace touchdown::config
