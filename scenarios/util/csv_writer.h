#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/angles.h"

namespace touchdown::util {

/// Function that receives consecutive pieces of a text.
using TextSink = std::function<void(std::string_view)>;

/// Writes a CSV text (RFC 4180): cells are separated by commas, texts are quoted if necessary, and lines end with LF.
/// Numbers have the fewest digits that read back to the same double.
class CsvWriter {
 public:
  CsvWriter() = default;
  /// Begins with the header line `header`, without a line end.
  explicit CsvWriter(std::string_view header) : text_(std::string(header) + '\n') {}
  /// Passes the text to `sink` instead of storing it. Take passes the last piece.
  CsvWriter(std::string_view header, TextSink sink) : text_(std::string(header) + '\n'), sink_(std::move(sink)) {}

  template <typename T>
  CsvWriter& operator<<(const T& cell) {
    if (!at_line_start_) text_ += ',';
    at_line_start_ = false;
    if constexpr (std::is_convertible_v<const T&, std::string_view>) {
      Append(cell);
    } else {
      fmt::format_to(std::back_inserter(text_), "{}", cell);
    }
    return *this;
  }
  CsvWriter& Vector(const Eigen::Vector3d& v) { return *this << v.x() << v.y() << v.z(); }
  /// Writes angles in degrees.
  CsvWriter& Angles(const models::TaitBryan& a) {
    return *this << models::RadToDeg(a.roll) << models::RadToDeg(a.pitch) << models::RadToDeg(a.yaw);
  }
  /// Writes an angular velocity in degrees per second.
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
    constexpr std::size_t kPiece_bytes = 1 << 16;
    if (sink_ && text_.size() >= kPiece_bytes) Flush();
  }
  /// Returns the text; empty if the writer has a sink.
  std::string Take() {
    if (sink_) Flush();
    return std::move(text_);
  }

 private:
  void Append(std::string_view cell) {
    if (cell.find_first_of(",\"\r\n") == std::string_view::npos) {
      text_ += cell;
      return;
    }
    text_ += '"';
    for (const char c : cell) text_.append(c == '"' ? 2 : 1, c);
    text_ += '"';
  }
  void Flush() {
    sink_(text_);
    text_.clear();
  }

  std::string text_;
  TextSink sink_;
  bool at_line_start_ = true;
};

/// One line of CSV, with its line end.
inline std::string CsvLine(const std::vector<std::string>& cells) {
  CsvWriter line;
  for (const std::string& cell : cells) line << cell;
  line.EndLine();
  return line.Take();
}

}  // namespace touchdown::util
