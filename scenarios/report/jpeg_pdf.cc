#include "scenarios/report/jpeg_pdf.h"

#include <cairo/cairo-pdf.h>

#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "scenarios/report/cairo_bytes.h"

namespace touchdown::report {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

cv::Size SizeOf(const std::string& jpeg) {
  const cv::Mat bytes(1, static_cast<int>(jpeg.size()), CV_8UC1, const_cast<char*>(jpeg.data()));
  const cv::Mat image = jpeg.empty() ? cv::Mat() : cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
  if (image.empty()) throw std::invalid_argument("the bytes are not a JPEG image");
  return image.size();
}

/// Cairo surface with the JPEG attached. Cairo writes the attached JPEG, not the pixels, to a PDF.
Surface JpegSurface(const std::string& jpeg, const cv::Size& size) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height), cairo_surface_destroy);
  cairo_surface_set_mime_data(surface.get(), CAIRO_MIME_TYPE_JPEG, reinterpret_cast<const unsigned char*>(jpeg.data()),
                              jpeg.size(), nullptr, nullptr);
  return surface;
}

}  // namespace

std::string JpegPdf(const std::string& jpeg, double width_cm) {
  constexpr double kPointsPerCm = 72.0 / 2.54;
  const cv::Size size = SizeOf(jpeg);
  const double scale = kPointsPerCm * width_cm / size.width;
  std::string bytes;
  {
    const Surface page(
        cairo_pdf_surface_create_for_stream(AppendBytes, &bytes, scale * size.width, scale * size.height),
        cairo_surface_destroy);
    cairo_pdf_surface_set_metadata(page.get(), CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
    const Surface image = JpegSurface(jpeg, size);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(page.get()), cairo_destroy);
    cairo_scale(cairo.get(), scale, scale);
    cairo_set_source_surface(cairo.get(), image.get(), 0.0, 0.0);
    cairo_paint(cairo.get());
  }
  return bytes;
}

}  // namespace touchdown::report
