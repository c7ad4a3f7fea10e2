#include "tests/support/docs_image.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

namespace touchdown::tests {

void ExpectDocsImage(const std::string& name, const cv::Mat& drawn, double tolerance) {
  const std::filesystem::path file = std::filesystem::path(TOUCHDOWN_SOURCE_DIR) / "docs" / "images" / name;
  if (std::getenv("TOUCHDOWN_WRITE_DOCS") != nullptr) {
    std::filesystem::create_directories(file.parent_path());
    ASSERT_TRUE(cv::imwrite(file.string(), drawn, {cv::IMWRITE_JPEG_QUALITY, 82, cv::IMWRITE_PNG_COMPRESSION, 9}));
  }
  const cv::Mat committed = cv::imread(file.string());
  ASSERT_EQ(committed.size(), drawn.size()) << name;
  EXPECT_LT(cv::norm(committed, drawn, cv::NORM_L1) / static_cast<double>(drawn.total() * 3), tolerance) << name;
}

}  // namespace touchdown::tests
