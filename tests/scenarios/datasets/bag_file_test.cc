// Bags from other sources, and invalid bags.
#include "scenarios/datasets/bag_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include <opencv2/imgcodecs.hpp>

#include "scenarios/datasets/bag_messages.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::datasets {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using tests::ThrowsInputError;

constexpr std::uint32_t kStart_s = 1'600'000'000;

template <typename Message>
Message Stamped(double time_s, const std::string& frame) {
  Message message;
  message.header.stamp = ros::Time(kStart_s) + ros::Duration(time_s);
  message.header.frame_id = frame;
  return message;
}

/// Uniform image of 4 x 2 px; each row ends with two bytes of padding.
ros1::Image UniformImage(double time_s, const std::string& encoding, const std::vector<std::uint8_t>& pixel) {
  auto image = Stamped<ros1::Image>(time_s, "camera_optical");
  image.width = 4;
  image.height = 2;
  image.encoding = encoding;
  for (std::uint32_t v = 0; v < image.height; ++v) {
    for (std::uint32_t u = 0; u < image.width; ++u) image.data.insert(image.data.end(), pixel.begin(), pixel.end());
    image.data.insert(image.data.end(), {0, 0});
  }
  image.step = static_cast<std::uint32_t>(image.data.size()) / image.height;
  return image;
}

ros1::Image Gray(double time_s, std::uint8_t value = 100) { return UniformImage(time_s, "mono8", {value}); }

ros1::Imu ImuAt(double time_s) {
  auto imu = Stamped<ros1::Imu>(time_s, "imu_link");
  imu.linear_acceleration.z = 9.8;
  imu.angular_velocity.x = 0.5;
  return imu;
}

ros1::CameraInfo Calibration() {
  auto info = Stamped<ros1::CameraInfo>(0.0, "camera_optical");
  info.width = 4;
  info.height = 2;
  info.distortion_model = "plumb_bob";
  info.D = {-0.2, 0.05, 0.001, -0.002, 0.003};
  info.K = {3.0, 0.0, 1.5, 0.0, 3.1, 0.5, 0.0, 0.0, 1.0};
  info.P = {2.5, 0.0, 1.4, 0.0, 0.0, 2.6, 0.6, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

ros1::TransformStamped HalfTurnMounting(const std::string& parent, const std::string& child, double x_m) {
  ros1::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = x_m;
  transform.transform.rotation.z = 1.0;  // 180 degrees about Z.
  return transform;
}

class BagFileTest : public ::testing::Test {
 protected:
  BagFileTest() { bag_.open(file_.string(), rosbag::bagmode::Write); }

  /// Adds a message with a recording time one second after its stamp.
  template <typename Message>
  void Add(const std::string& topic, const Message& message) {
    bag_.write(topic, message.header.stamp + ros::Duration(1.0), message);
  }
  void AddMounting(const std::vector<ros1::TransformStamped>& transforms) {
    ros1::TFMessage message;
    message.transforms.assign(transforms.begin(), transforms.end());
    bag_.write("/tf_static", ros::Time(kStart_s), message);
  }

  BagFile Open(const std::vector<std::string>& topics = {}) {
    bag_.close();
    return {file_, topics};
  }
  auto Reading(const std::vector<std::string>& topics = {}) {
    return [this, topics] {
      BagFile bag = Open(topics);
      while (bag.Next()) continue;
    };
  }
  /// Gray level of the first pixel of each image.
  std::vector<int> Grays(const std::vector<std::string>& topics = {}) {
    BagFile bag = Open(topics);
    std::vector<int> grays;
    while (const auto frame = bag.Next()) grays.push_back(frame->image.pixels.front());
    return grays;
  }

  tests::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "foreign.bag";
  rosbag::Bag bag_;
};

TEST_F(BagFileTest, ReadsImagesOfAllSupportedEncodings) {
  double time_s = 0.0;
  for (const char* encoding : {"mono8", "8UC1"}) Add("/camera/image", UniformImage(time_s += 0.1, encoding, {77}));
  for (const char* encoding : {"mono16", "16UC1"})
    Add("/camera/image", UniformImage(time_s += 0.1, encoding, {77, 77}));
  for (const char* encoding : {"bgr8", "8UC3"})
    Add("/camera/image", UniformImage(time_s += 0.1, encoding, {0, 0, 200}));
  Add("/camera/image", UniformImage(time_s += 0.1, "rgb8", {200, 0, 0}));
  for (const char* encoding : {"bgra8", "8UC4"}) {
    Add("/camera/image", UniformImage(time_s += 0.1, encoding, {0, 0, 200, 255}));
  }
  Add("/camera/image", UniformImage(time_s += 0.1, "rgba8", {200, 0, 0, 255}));
  EXPECT_THAT(Grays(), ElementsAre(77, 77, 77, 77, 60, 60, 60, 60, 60, 60));  // Weight of red: 0.299.
}

TEST_F(BagFileTest, ReadsCompressedImagesAndTheirCameraInfo) {
  auto image = Stamped<ros1::CompressedImage>(0.1, "camera_optical");
  image.format = "png";
  std::vector<std::uint8_t> png;
  cv::imencode(".png", cv::Mat(2, 4, CV_8UC1, cv::Scalar(42)), png);
  image.data.assign(png.begin(), png.end());
  Add("/camera/image_raw/compressed", image);
  Add("/camera/camera_info", Calibration());
  BagFile bag = Open();
  EXPECT_EQ(bag.metadata().camera.value().fy_px, 3.1);
  EXPECT_EQ(bag.Next().value().image.pixels, std::vector<std::uint8_t>(8, 42));
}

TEST_F(BagFileTest, ReadsTimesCameraImuAndMounting) {
  Add("/camera/image_raw", Gray(0.5));
  Add("/camera/image_raw", Gray(0.75, 101));
  Add("/camera/camera_info", Calibration());
  Add("/imu", ImuAt(0.49));
  Add("/imu", ImuAt(0.50));
  AddMounting({HalfTurnMounting("map", "base_link", 99.0), HalfTurnMounting("base_link", "camera", 0.1),
               HalfTurnMounting("base_link", "imu_link", 0.02)});
  AddMounting({HalfTurnMounting("camera", "camera_optical", 0.03)});
  BagFile bag = Open();
  const FootageMetadata& metadata = bag.metadata();
  EXPECT_EQ(metadata.frame_order, estimator::FrameOrder::kSequence);
  EXPECT_EQ(metadata.frame_count, 2u);
  EXPECT_NEAR(metadata.frames_per_s, 4.0, 1e-9);
  EXPECT_FALSE(metadata.latency || metadata.pad || metadata.estimator);
  const models::CameraModel& camera = metadata.camera.value();
  EXPECT_THAT((std::vector<double>{camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px}),
              ElementsAre(3.0, 3.1, 1.5, 0.5));
  EXPECT_THAT((std::vector<double>{camera.k1, camera.k2, camera.p1, camera.p2, camera.k3}),
              ElementsAre(-0.2, 0.05, 0.001, -0.002, 0.003));
  ASSERT_EQ(metadata.imu.size(), 2u);
  EXPECT_EQ(metadata.imu[0].sample.tick, 1'600'000'000'490'000);
  EXPECT_EQ(metadata.imu[0].sample.specific_force_U, Eigen::Vector3d(0.0, 0.0, 9.8));
  EXPECT_EQ(metadata.imu[0].sample.w_WU_U, Eigen::Vector3d(0.5, 0.0, 0.0));
  // Camera: half turn at x = 0.1 m, then a second half turn at -0.03 m along the body's X axis.
  EXPECT_TRUE(metadata.mounting.value().X_BC.isApprox(Eigen::Isometry3d(Eigen::Translation3d(0.07, 0.0, 0.0)), 1e-12));
  EXPECT_NEAR(metadata.mounting.value().X_BU.translation().x(), 0.02, 1e-12);
  EXPECT_EQ(bag.Next().value().mid_exposure, 1'600'000'000'500'000);
  const auto second = bag.Next();
  EXPECT_EQ(second.value().source, "foreign.bag");
  EXPECT_EQ(second.value().image.pixels, std::vector<std::uint8_t>(8, 101));
  EXPECT_FALSE(bag.Next());
}

TEST_F(BagFileTest, UsesTheRecordingTimeWithoutAStamp) {
  ros1::Image image = Gray(0.0);
  image.header.stamp = ros::Time(0);
  bag_.write("/image", ros::Time(12, 5000), image);
  EXPECT_EQ(Open().Next().value().mid_exposure, 12'000'005);
}

TEST_F(BagFileTest, HasNoMountingUnlessCameraAndImuShareABody) {
  Add("/image", Gray(0.0));
  Add("/imu", ImuAt(0.0));
  AddMounting({HalfTurnMounting("base_link", "camera_optical", 0.1), HalfTurnMounting("gimbal", "imu_link", 0.1)});
  EXPECT_FALSE(Open().metadata().mounting);
}

TEST_F(BagFileTest, UsesTheImuFrameAsBodyWhenItIsTheRoot) {
  Add("/image", Gray(0.0));
  Add("/imu", ImuAt(0.0));
  AddMounting({HalfTurnMounting("/imu_link", "camera_optical", 0.1)});
  const SensorMounting mounting = Open().metadata().mounting.value();
  EXPECT_EQ(mounting.X_BC.translation().x(), 0.1);
  EXPECT_TRUE(mounting.X_BU.isApprox(Eigen::Isometry3d::Identity()));
}

TEST_F(BagFileTest, UsesTheProjectionOfRectifiedImagesAndIgnoresOtherDistortionModels) {
  Add("/a/image_rect", Gray(0.0));
  Add("/a/camera_info", Calibration());
  Add("/b/image_raw", Gray(0.0));
  ros1::CameraInfo fisheye = Calibration();
  fisheye.distortion_model = "equidistant";
  fisheye.D.resize(4);
  Add("/b/camera_info", fisheye);
  Add("/c/image_raw", Gray(0.0));
  const models::CameraModel rectified = Open({"/a/image_rect"}).metadata().camera.value();
  EXPECT_THAT((std::vector<double>{rectified.fx_px, rectified.fy_px, rectified.cx_px, rectified.cy_px, rectified.k1}),
              ElementsAre(2.5, 2.6, 1.4, 0.6, 0.0));
  EXPECT_FALSE(BagFile(file_, {"/b/image_raw"}).metadata().camera);
  EXPECT_FALSE(BagFile(file_, {"/c/image_raw"}).metadata().camera);
}

TEST_F(BagFileTest, RequiresTopicsForSeveralCamerasOrImus) {
  Add("/left/image_raw", Gray(0.0, 1));
  Add("/right/image_raw", Gray(0.0, 2));
  Add("/imu/data", ImuAt(0.0));
  Add("/imu/data_raw", ImuAt(0.5));
  EXPECT_THAT(
      Reading(),
      ThrowsInputError(file_.string() +
                       ": several topics with images; select one with --topic: /left/image_raw, /right/image_raw"));
  EXPECT_THAT(Reading({"/right/image_raw"}),
              ThrowsInputError(file_.string() +
                               ": several topics with IMU samples; select one with --topic: /imu/data, /imu/data_raw"));
  EXPECT_THAT(Reading({"/wrong/image_raw"}),
              ThrowsInputError(file_.string() + ": no images or IMU samples on topic /wrong/image_raw"));
  EXPECT_THAT(Grays({"/imu/data_raw", "/right/image_raw"}), ElementsAre(2));
}

TEST_F(BagFileTest, RejectsABagWithoutImages) {
  Add("/imu", ImuAt(0.0));
  EXPECT_THAT(Reading(), ThrowsInputError(file_.string() + ": no image topic (sensor_msgs/Image or CompressedImage)"));
}

TEST_F(BagFileTest, RejectsBayerPatternsAndMalformedImages) {
  Add("/bayer", UniformImage(0.0, "bayer_rggb8", {1}));
  ros1::Image cut = Gray(0.0);
  cut.data.pop_back();
  Add("/cut", cut);
  ros1::Image endless = Gray(0.0);
  endless.width = endless.height = endless.step = 0xffffffff;
  Add("/endless", endless);
  auto compressed = Stamped<ros1::CompressedImage>(0.0, "camera_optical");
  compressed.format = "jpeg";
  Add("/compressed", compressed);
  EXPECT_THAT(Reading({"/bayer"}),
              ThrowsInputError(AllOf(StartsWith(file_.string()),
                                     HasSubstr("unsupported image encoding bayer_rggb8; allowed: mono8, "))));
  EXPECT_THAT(Reading({"/cut"}), ThrowsInputError(file_.string() + ": malformed image message of 4 x 2 px"));
  EXPECT_THAT(Reading({"/endless"}),
              ThrowsInputError(file_.string() + ": malformed image message of 4294967295 x 4294967295 px"));
  EXPECT_THAT(Reading({"/compressed"}),
              ThrowsInputError(file_.string() + ": cannot decode compressed image (format jpeg)"));
}

TEST_F(BagFileTest, RejectsTimesThatDoNotIncrease) {
  for (const double time_s : {0.0, 0.2, 0.1}) {
    ros1::Image image = Gray(time_s);
    bag_.write("/image", ros::Time(kStart_s) + ros::Duration(1.0 + 0.1 * static_cast<double>(bag_.getSize())), image);
  }
  EXPECT_THAT(Reading(),
              ThrowsInputError(file_.string() +
                               ": topic /image: the time of message 2 is not after that of the message before"));
}

TEST_F(BagFileTest, RejectsAFileThatIsNotABag) {
  bag_.close();
  folder_.Put("foreign.bag", "not a bag");
  EXPECT_THAT(Reading(), ThrowsInputError(file_.string() + ": not a readable ROS bag, or truncated"));
}

}  // namespace
}  // namespace touchdown::datasets
