#include "estimator/paper/components.h"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::estimator::paper {
namespace {

constexpr ComponentsConfig kKeepAll{1, 1, 1};

models::Image FromText(const std::vector<std::string>& rows) {
  models::Image image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      image.Row(v)[u] = rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(u)] == '#' ? 255 : 0;
    }
  }
  return image;
}

models::Image RandomImage(int width, int height, double density, std::uint64_t seed) {
  models::RandomStream random(seed, "tests.components");
  models::Image image(width, height);
  for (auto& pixel : image.pixels) pixel = random.Bernoulli(density) ? 255 : 0;
  return image;
}

/// Label image of the components: a pixel is 1 + the index of its component, or 0.
std::vector<int> LabelImage(const ComponentSet& set, int width, int height) {
  std::vector<int> labels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  int label = 0;
  for (const Component& component : set.components) {
    ++label;
    for (const Run& run : set.RunsOf(component)) {
      for (int u = run.u_begin; u < run.u_end; ++u) {
        int& pixel =
            labels[static_cast<std::size_t>(run.v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)];
        EXPECT_EQ(pixel, 0) << "pixel in two components";
        pixel = label;
      }
    }
  }
  return labels;
}

void ExpectEqualToOpenCv(const models::Image& image) {
  const ComponentSet set = ExtractComponents(image.View(), kKeepAll);
  const cv::Mat gray(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data()));
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(gray, labels, stats, centroids, 8, CV_32S);
  ASSERT_EQ(set.components.size(), static_cast<std::size_t>(count - 1));

  const std::vector<int> ours = LabelImage(set, image.width, image.height);
  std::map<int, int> theirs_of_ours;
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const int our =
          ours[static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(u)];
      const int their = labels.at<int>(v, u);
      const auto [entry, is_new] = theirs_of_ours.emplace(our, their);
      ASSERT_EQ(entry->second, their) << u << ", " << v;
    }
  }
  for (std::size_t i = 0; i < set.components.size(); ++i) {
    const Component& component = set.components[i];
    const int their = theirs_of_ours.at(static_cast<int>(i) + 1);
    EXPECT_EQ(component.u, stats.at<int>(their, cv::CC_STAT_LEFT));
    EXPECT_EQ(component.v, stats.at<int>(their, cv::CC_STAT_TOP));
    EXPECT_EQ(component.width, stats.at<int>(their, cv::CC_STAT_WIDTH));
    EXPECT_EQ(component.height, stats.at<int>(their, cv::CC_STAT_HEIGHT));
    EXPECT_EQ(component.area, stats.at<int>(their, cv::CC_STAT_AREA));
  }
}

TEST(Components, EqualOpenCvOnRandomImages) {
  std::uint64_t seed = 0;
  for (const double density : {0.0, 0.05, 0.3, 0.4, 0.5, 0.6, 0.9, 1.0}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 30}, {30, 1}, {7, 9}, {64, 48}, {131, 77}}) {
      ExpectEqualToOpenCv(RandomImage(width, height, density, ++seed));
    }
  }
}

TEST(Components, EqualOpenCvOnShapesThatMergeLate) {
  ExpectEqualToOpenCv(FromText({"#.#.#.#.#", "#.#.#.#.#", "#########"}));
  ExpectEqualToOpenCv(FromText({"#.......#", ".#.....#.", "..#...#..", "...#.#...", "....#...."}));
  ExpectEqualToOpenCv(FromText({"#########", "........#", "#######.#", "#.....#.#", "#.###.#.#", "#.#...#.#",
                                "#.#####.#", "#.......#", "#########"}));
  ExpectEqualToOpenCv(FromText({"##.##.##.", "..#..#..#", "##.##.##.", "..#..#..#"}));
  ExpectEqualToOpenCv(FromText({"#..#", "....", "....", "#..#"}));
  ExpectEqualToOpenCv(FromText({".#.#.#.", "#.#.#.#", ".#.#.#.", "#.#.#.#"}));
}

TEST(Components, AreOrderedByFirstPixelWithRunsInRasterOrder) {
  const models::Image image = FromText({"..##...#", "#......#", "#.##...#"});
  const ComponentSet set = ExtractComponents(image.View(), kKeepAll);
  ASSERT_EQ(set.components.size(), 4u);
  EXPECT_EQ(set.components[0].u, 2);
  EXPECT_EQ(set.components[1].u, 7);
  const auto runs = set.RunsOf(set.components[1]);
  ASSERT_EQ(runs.size(), 3u);
  for (int v = 0; v < 3; ++v) EXPECT_EQ(runs[static_cast<std::size_t>(v)], (paper::Run{v, 7, 8}));
}

TEST(Components, AreFilteredBySize) {
  const models::Image image = RandomImage(90, 70, 0.35, 99);
  const ComponentSet all = ExtractComponents(image.View(), kKeepAll);
  const ComponentsConfig config{9, 4, 24};
  const ComponentSet kept = ExtractComponents(image.View(), config);
  std::size_t next = 0;
  for (const Component& component : all.components) {
    if (std::max(component.width, component.height) < 9 || std::min(component.width, component.height) < 4 ||
        component.area < 24) {
      continue;
    }
    ASSERT_LT(next, kept.components.size());
    const auto expected = all.RunsOf(component), actual = kept.RunsOf(kept.components[next++]);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), actual.begin(), actual.end()));
  }
  EXPECT_EQ(next, kept.components.size());
  EXPECT_GT(next, 0u);
  EXPECT_LT(next, all.components.size());
}

TEST(Components, UseTheStride) {
  const models::Image image = FromText({"#..#", "#..#", "####"});
  const models::ImageView two_columns{image.pixels.data(), 2, 2, 4};
  const ComponentSet set = ExtractComponents(two_columns, kKeepAll);
  ASSERT_EQ(set.components.size(), 1u);
  EXPECT_EQ(set.components[0].area, 2);
}

TEST(Components, RejectInvalidSettings) {
  EXPECT_THROW((ComponentsConfig{0, 1, 1}.Validate()), InputError);
  EXPECT_THROW((ComponentsConfig{1, -1, 1}.Validate()), InputError);
  EXPECT_THROW((ComponentsConfig{1, 1, 0}.Validate()), InputError);
}

}  // namespace
}  // namespace touchdown::estimator::paper
