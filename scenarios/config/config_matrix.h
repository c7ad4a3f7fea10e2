#pragma once

#include <vector>

#include "models/describe.h"

namespace touchdown::config {

/// A matrix as ROS and EuRoC files hold it, in a section of rows, cols and data. Row by row; empty when it is not
/// given.
struct ConfigMatrix {
  int rows = 0;
  int cols = 0;
  std::vector<double> data;
};

/// A section of so many rows and columns, with as many numbers.
void DescribeMatrix(models::ConfigVisitor& v, const models::Key& key, ConfigMatrix& matrix, const models::Range& rows,
                    const models::Range& cols);

}  // namespace touchdown::config
