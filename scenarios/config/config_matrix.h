#pragma once

#include <vector>

#include "models/describe.h"

namespace touchdown::config {

/// Matrix of a ROS or EuRoC file, a section with rows, cols and data. Row-major; empty when absent.
struct ConfigMatrix {
  int rows = 0;
  int cols = 0;
  std::vector<double> data;
};

/// Section of a matrix with the given rows, columns and numbers.
void DescribeMatrix(models::ConfigVisitor& v, const models::Key& key, ConfigMatrix& matrix, const models::Range& rows,
                    const models::Range& cols);

}  // namespace touchdown::config
