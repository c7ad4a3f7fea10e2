#include "scenarios/datasets/flight_bag.h"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <rosbag/bag.h>

#include <boost/make_shared.hpp>
#include <optional>
#include <string>
#include <system_error>

#include "models/error.h"
#include "scenarios/datasets/bag_messages.h"
#include "scenarios/runner/tum_trajectory.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;

constexpr const char *kWorldFrame = "world", *kBodyFrame = "base_link", *kCameraFrame = "camera", *kImuFrame = "imu";

/// A Point or a Vector3.
template <typename Message>
Message XyzOf(const Eigen::Vector3d& v) {
  Message message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

ros1::Quaternion QuaternionOf(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  ros1::Quaternion quaternion;
  quaternion.x = q.x();
  quaternion.y = q.y();
  quaternion.z = q.z();
  quaternion.w = q.w();
  return quaternion;
}

ros1::Pose PoseOf(const Eigen::Isometry3d& X) {
  ros1::Pose pose;
  pose.position = XyzOf<ros1::Point>(X.translation());
  pose.orientation = QuaternionOf(X.linear());
  return pose;
}

ros1::Header HeaderOf(const ros::Time& stamp, const char* frame) {
  ros1::Header header;
  header.stamp = stamp;
  header.frame_id = frame;
  return header;
}

ros1::PoseStamped BodyPose(const ros::Time& stamp, const Eigen::Isometry3d& X_WB) {
  ros1::PoseStamped message;
  message.header = HeaderOf(stamp, kWorldFrame);
  message.pose = PoseOf(X_WB);
  return message;
}

/// The covariance needs no change: both are of position and rotation about the world's fixed axes, in this order.
ros1::PoseWithCovarianceStamped EstimatedPose(const ros::Time& stamp, const estimator::VisionPose& pose) {
  ros1::PoseWithCovarianceStamped message;
  message.header = HeaderOf(stamp, kWorldFrame);
  message.pose.pose = PoseOf(pose.X_WB);
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(message.pose.covariance.data()) = pose.covariance;
  return message;
}

ros1::TransformStamped Transform(const ros::Time& stamp, const char* parent, const char* child,
                                 const Eigen::Isometry3d& X) {
  ros1::TransformStamped transform;
  transform.header = HeaderOf(stamp, parent);
  transform.child_frame_id = child;
  transform.transform.translation = XyzOf<ros1::Vector3>(X.translation());
  transform.transform.rotation = QuaternionOf(X.linear());
  return transform;
}

ros1::CameraInfo CameraInfoOf(const models::CameraModel& c) {
  ros1::CameraInfo info;
  info.header.frame_id = kCameraFrame;
  info.width = static_cast<std::uint32_t>(c.width_px);
  info.height = static_cast<std::uint32_t>(c.height_px);
  info.distortion_model = "plumb_bob";
  info.D = {c.k1, c.k2, c.p1, c.p2, c.k3};
  info.K = {c.fx_px, 0.0, c.cx_px, 0.0, c.fy_px, c.cy_px, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {c.fx_px, 0.0, c.cx_px, 0.0, 0.0, c.fy_px, c.cy_px, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

/// What every sample has in common: no orientation, and of each axis the noise's variance, which is 0 ("unknown" to
/// ROS) where there is none.
ros1::Imu ImuOf(const sim::ImuConfig& config) {
  const auto variance = [&config](double density) { return density * density * config.rate_hz; };
  ros1::Imu imu;
  imu.header.frame_id = kImuFrame;
  imu.orientation.w = 1.0;
  imu.orientation_covariance[0] = -1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    imu.angular_velocity_covariance[4 * axis] = variance(config.gyro_noise_rad_s_sqrt_hz);
    imu.linear_acceleration_covariance[4 * axis] = variance(config.accelerometer_noise_m_s2_sqrt_hz);
  }
  return imu;
}

ros1::Image ImageOf(const ros::Time& stamp, const models::Image& image) {
  ros1::Image message;
  message.header = HeaderOf(stamp, kCameraFrame);
  message.width = static_cast<std::uint32_t>(image.width);
  message.height = static_cast<std::uint32_t>(image.height);
  message.encoding = "mono8";
  message.step = message.width;
  message.data.assign(image.pixels.begin(), image.pixels.end());
  return message;
}

/// The fields of a topic whose newest message every later listener is to get.
template <typename Message>
boost::shared_ptr<ros::M_string> LatchedFields() {
  auto fields = boost::make_shared<ros::M_string>();
  (*fields)["type"] = ros::message_traits::datatype<Message>();
  (*fields)["md5sum"] = ros::message_traits::md5sum<Message>();
  (*fields)["message_definition"] = ros::message_traits::definition<Message>();
  (*fields)["latching"] = "1";
  return fields;
}

}  // namespace

struct FlightBag::Impl {
  Impl(const runner::Scenario& scenario, const fs::path& place)
      : file(place),
        time(scenario.time),
        camera_info(CameraInfoOf(scenario.assumed_camera())),
        imu(ImuOf(scenario.imu)) {
    console_bridge::noOutputHandler();  // What goes wrong is thrown.
  }

  ~Impl() {
    if (finished) return;
    try {
      Close();
    } catch (const InputError&) {  // There is nothing to be kept.
    }
    std::error_code ignored;
    if (is_made) fs::remove(file, ignored);
  }

  void Open() {
    Try([this] { bag->open(file.string(), rosbag::bagmode::Write); });
    is_made = true;
  }

  void Close() {
    if (bag) Try([this] { bag->close(); });
  }

  /// Throws InputError for what the library throws in `action`. A bag that could not be written is let go of, never
  /// destroyed: its destructor would write again, and end the program when it could not.
  template <typename Action>
  void Try(const Action& action) {
    try {
      action();
    } catch (const rosbag::BagException& error) {
      is_made = bag->isOpen();
      if (is_made) static_cast<void>(bag.release());
      throw InputError(fmt::format("bag {}: cannot be written: {}", file.filename().string(), error.what()));
    }
  }

  template <typename Message>
  void Put(const char* topic, const ros::Time& recorded, const Message& message) {
    Try([&] { bag->write(topic, recorded, message); });
  }
  template <typename Message>
  void PutLatched(const char* topic, const ros::Time& recorded, const Message& message) {
    Try([&] { bag->write(topic, recorded, message, LatchedFields<Message>()); });
  }

  ros::Time At(models::Tick tick) const {
    ros::Time stamp;
    stamp.fromNSec(static_cast<std::uint64_t>(kBagEpoch_ns + time.ToNanoseconds(tick)));
    return stamp;
  }

  /// What holds for the whole flight, with its first sample: before that its beginning is not known.
  void PutFacts(const ros::Time& begin) {
    ros1::String text;
    text.data = scenario_yaml;
    PutLatched(kScenarioTopic, begin, text);
    ros1::TFMessage mounting;
    mounting.transforms = {Transform(begin, kBodyFrame, kCameraFrame, X_BC),
                           Transform(begin, kBodyFrame, kImuFrame, X_BU)};
    PutLatched("/tf_static", begin, mounting);
  }

  void PutTruth(models::Tick tick, const Eigen::Isometry3d& X_WB) {
    Put("/truth", At(tick), BodyPose(At(tick), X_WB));
    ros1::TFMessage transforms;
    transforms.transforms = {Transform(At(tick), kWorldFrame, kBodyFrame, X_WB)};
    Put("/tf", At(tick), transforms);
  }

  fs::path file;
  models::TimeBase time;
  std::string scenario_yaml;
  Eigen::Isometry3d X_BC, X_BU;
  ros1::CameraInfo camera_info;
  ros1::Imu imu;
  std::unique_ptr<rosbag::Bag> bag = std::make_unique<rosbag::Bag>();
  std::optional<bool> was_at_rest;
  bool is_made = false;
  bool finished = false;
};

FlightBag::FlightBag(const runner::Scenario& scenario, const fs::path& file)
    : impl_(std::make_unique<Impl>(scenario, file)) {
  impl_->scenario_yaml = runner::ScenarioYaml(scenario);
  const models::Vehicle assumed = scenario.assumed_vehicle();
  impl_->X_BC = assumed.X_BC();
  impl_->X_BU = assumed.X_BU();
  impl_->Open();
}

FlightBag::~FlightBag() = default;

void FlightBag::OnImu(const models::ImuSample& sample, bool at_rest) {
  const ros::Time stamp = impl_->At(sample.tick);
  if (!impl_->was_at_rest) impl_->PutFacts(stamp);
  if (impl_->was_at_rest != at_rest) {
    ros1::Bool flag;
    flag.data = at_rest;
    impl_->PutLatched(kAtRestTopic, stamp, flag);
    impl_->was_at_rest = at_rest;
  }
  impl_->imu.header.stamp = stamp;
  impl_->imu.angular_velocity = XyzOf<ros1::Vector3>(sample.w_WU_U);
  impl_->imu.linear_acceleration = XyzOf<ros1::Vector3>(sample.specific_force_U);
  impl_->Put("/imu/data_raw", stamp, impl_->imu);
}

void FlightBag::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& /*estimate*/,
                        const runner::FrameRecord& record) {
  const ros::Time stamp = impl_->At(frame.mid_exposure), delivered = impl_->At(record.delivered);
  impl_->camera_info.header.stamp = stamp;
  impl_->Put("/camera/camera_info", delivered, impl_->camera_info);
  impl_->Put("/camera/image_raw", delivered, ImageOf(stamp, frame.image));
  if (record.status == estimator::FrameStatus::kOk) {
    impl_->Put("/estimate", delivered, EstimatedPose(stamp, record.pose.value()));
  }
}

void FlightBag::Finish(const runner::FlightLog& log) {
  // Who plays the bag goes back and forth between these chunks and those with the frames, and reads each as a whole.
  constexpr std::uint32_t kSmallChunk_bytes = 64 * 1024;
  impl_->Try([this] { impl_->bag->setChunkThreshold(kSmallChunk_bytes); });
  for (const auto& [tick, X_WB] : runner::TrueTrajectory(log)) impl_->PutTruth(tick, X_WB);
  for (const auto& [tick, X_WB] : runner::TrackedTrajectory(log)) {
    impl_->Put("/tracking", impl_->At(tick), BodyPose(impl_->At(tick), X_WB));
  }
  impl_->Close();
  impl_->finished = true;
}

}  // namespace touchdown::datasets
