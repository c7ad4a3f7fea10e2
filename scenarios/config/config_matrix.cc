#include "scenarios/config/config_matrix.h"

namespace touchdown::config {

void DescribeMatrix(models::ConfigVisitor& v, const models::Key& key, ConfigMatrix& matrix, const models::Range& rows,
                    const models::Range& cols) {
  const auto describe = [&](models::ConfigVisitor& m) {
    m.Integer({"rows", "", true}, matrix.rows, rows);
    m.Integer({"cols", "", true}, matrix.cols, cols);
    matrix.data.resize(static_cast<std::size_t>(matrix.rows) * static_cast<std::size_t>(matrix.cols));
    std::vector<double*> data;
    for (double& value : matrix.data) data.push_back(&value);
    m.Numbers({"data", "", true}, data, models::kNoUnit, models::kAny);
  };
  if (key.required) {
    v.Section(key, {}, describe);
  } else {
    v.OptionalSection(key, !matrix.data.empty(), {}, describe);
  }
}

}  // namespace touchdown::config
