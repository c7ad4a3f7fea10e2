#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "models/angles.h"

namespace touchdown::util {

/// The text of a CSV file while it is written: a header, cells with commas between them and a line's end behind.
/// Numbers are the shortest that read back to the same double; angles are told in degrees.
class CsvWriter {
 public:
  explicit CsvWriter(std::string_view header) : text_(std::string(header) + '\n') {}

  template <typename T>
  CsvWriter& operator<<(const T& cell) {
    if (!at_line_start_) text_ += ',';
    at_line_start_ = false;
    fmt::format_to(std::back_inserter(text_), "{}", cell);
    return *this;
  }
  /// Text that somebody else wrote: in quotes where it needs them (RFC 4180).
  CsvWriter& Text(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return *this << text;
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return *this << quoted + '"';
  }
  CsvWriter& Vector(const Eigen::Vector3d& v) { return *this << v.x() << v.y() << v.z(); }
  CsvWriter& Angles(const models::TaitBryan& a) {
    return *this << models::RadToDeg(a.roll) << models::RadToDeg(a.pitch) << models::RadToDeg(a.yaw);
  }
  CsvWriter& Rates(const Eigen::Vector3d& w) { return Vector(w * (180.0 / models::kPi)); }
  CsvWriter& Pose(const Eigen::Isometry3d& X_WB) {
    return Vector(X_WB.translation()).Angles(models::TaitBryanFromRotation(X_WB.linear()));
  }
  CsvWriter& Pixel(const std::optional<Eigen::Vector2d>& p) { return p ? *this << p->x() << p->y() : Empty(2); }
  CsvWriter& Empty(int cells) {
    for (int i = 0; i < cells; ++i) *this << "";
    return *this;
  }
  void EndLine() {
    text_ += '\n';
    at_line_start_ = true;
  }
  std::string Take() { return std::move(text_); }

 private:
  std::string text_;
  bool at_line_start_ = true;
};

}  // namespace touchdown::util
