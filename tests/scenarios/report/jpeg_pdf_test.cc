#include "scenarios/report/jpeg_pdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

namespace touchdown::report {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string Jpeg() {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", cv::Mat3b(100, 200, cv::Vec3b(10, 200, 30)), bytes);
  return {bytes.begin(), bytes.end()};
}

TEST(JpegPdf, ContainsUnchangedJpeg) {
  const std::string pdf = JpegPdf(Jpeg(), 10.0);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_THAT(pdf, HasSubstr("/DCTDecode"));
  EXPECT_THAT(pdf, HasSubstr(Jpeg()));
  EXPECT_EQ(pdf, JpegPdf(Jpeg(), 10.0));
}

TEST(JpegPdf, ThrowsForInvalidJpeg) {
  EXPECT_THROW(JpegPdf("not a JPEG", 10.0), std::invalid_argument);
  EXPECT_THROW(JpegPdf("", 10.0), std::invalid_argument);
}

}  // namespace
}  // namespace touchdown::report
