#pragma once

#include <string>

namespace touchdown::report {

/// A JPEG as a PDF of one page of that width, which holds the JPEG as it is. The same picture gives the same PDF.
/// Throws std::invalid_argument for bytes that are no JPEG.
std::string PicturePdf(const std::string& jpeg, double width_cm);

}  // namespace touchdown::report
