#pragma once

#include <string>

namespace touchdown::report {

/// Embeds the unchanged bytes of a JPEG in a PDF with one page of the given width. Equal images give equal PDFs. Throws
/// std::invalid_argument when the bytes are not a JPEG image.
std::string JpegPdf(const std::string& jpeg, double width_cm);

}  // namespace touchdown::report
