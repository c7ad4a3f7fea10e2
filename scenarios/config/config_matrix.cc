#include "scenarios/config/config_matrix.h"

namespace touchdown::config {

void DescribeMatrix(ConfigVisitor& v, const Key& key, ConfigMatrix& matrix, const Range& rows, const Range& cols) {
  v.Section(key, {}, [&](ConfigVisitor& m) {
    m.Integer({"rows", "", true}, matrix.rows, rows);
    m.Integer({"cols", "", true}, matrix.cols, cols);
    matrix.data.resize(static_cast<std::size_t>(matrix.rows) * static_cast<std::size_t>(matrix.cols));
    std::vector<double*> data;
    for (double& value : matrix.data) data.push_back(&value);
    m.Numbers({"data", "", true}, data, kNoUnit, kAny);
  });
}

}  // namespace touchdown::config
