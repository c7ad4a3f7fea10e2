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

/// Converts a vector to a ROS Point or Vector3.
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

/// The covariance is copied as is: ROS and VisionPose both use position and rotation about fixed axes, in this order.
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

/// Fields common to all IMU messages: no orientation, and the noise variance per axis. The variance is 0, which means
/// "unknown" in ROS, when the scenario has no noise.
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

/// Connection header of a latched topic, whose last message is sent to each new subscriber.
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
  Impl(const runner::Scenario& scenario, const fs::path& path)
      : file(path),
        time(scenario.time),
        camera_info(CameraInfoOf(scenario.assumed_camera())),
        imu(ImuOf(scenario.imu)) {
    console_bridge::noOutputHandler();  // Errors are reported by exceptions.
  }

  ~Impl() {
    if (finished) return;
    try {
      Close();
    } catch (const InputError&) {  // The file is removed below.
    }
    std::error_code ignored;
    if (is_made) fs::remove(file, ignored);
  }

  void Open() {
    Guarded([this] { bag->open(file.string(), rosbag::bagmode::Write); });
    is_made = true;
  }

  void Close() {
    if (bag) Guarded([this] { bag->close(); });
  }

  /// Calls `action`, and rethrows exceptions of the library as InputError. After an error, an open bag is leaked on
  /// purpose: its destructor would write again, and terminate the program when that fails.
  template <typename Action>
  void Guarded(const Action& action) {
    try {
      action();
    } catch (const rosbag::BagException& error) {
      is_made = bag->isOpen();
      if (is_made) static_cast<void>(bag.release());
      throw InputError(fmt::format("bag {}: cannot be written: {}", file.filename().string(), error.what()));
    }
  }

  template <typename Message>
  void WriteMessage(const char* topic, const ros::Time& recorded, const Message& message) {
    Guarded([&] { bag->write(topic, recorded, message); });
  }
  template <typename Message>
  void WriteLatched(const char* topic, const ros::Time& recorded, const Message& message) {
    Guarded([&] { bag->write(topic, recorded, message, LatchedFields<Message>()); });
  }

  ros::Time StampOf(models::Tick tick) const {
    ros::Time stamp;
    stamp.fromNSec(static_cast<std::uint64_t>(kBagEpoch_ns + time.ToNanoseconds(tick)));
    return stamp;
  }

  /// Writes the scenario and the mounting. Called with the first IMU sample, whose time is the beginning of the bag.
  void WriteStaticMessages(const ros::Time& begin) {
    ros1::String text;
    text.data = scenario_yaml;
    WriteLatched(kScenarioTopic, begin, text);
    ros1::TFMessage mounting;
    mounting.transforms = {Transform(begin, kBodyFrame, kCameraFrame, X_BC),
                           Transform(begin, kBodyFrame, kImuFrame, X_BU)};
    WriteLatched("/tf_static", begin, mounting);
  }

  void WriteTruth(models::Tick tick, const Eigen::Isometry3d& X_WB) {
    WriteMessage("/truth", StampOf(tick), BodyPose(StampOf(tick), X_WB));
    ros1::TFMessage transforms;
    transforms.transforms = {Transform(StampOf(tick), kWorldFrame, kBodyFrame, X_WB)};
    WriteMessage("/tf", StampOf(tick), transforms);
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
  const ros::Time stamp = impl_->StampOf(sample.tick);
  if (!impl_->was_at_rest) impl_->WriteStaticMessages(stamp);
  if (impl_->was_at_rest != at_rest) {
    ros1::Bool flag;
    flag.data = at_rest;
    impl_->WriteLatched(kAtRestTopic, stamp, flag);
    impl_->was_at_rest = at_rest;
  }
  impl_->imu.header.stamp = stamp;
  impl_->imu.angular_velocity = XyzOf<ros1::Vector3>(sample.w_WU_U);
  impl_->imu.linear_acceleration = XyzOf<ros1::Vector3>(sample.specific_force_U);
  impl_->WriteMessage("/imu/data_raw", stamp, impl_->imu);
}

void FlightBag::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& /*estimate*/,
                        const runner::FrameRecord& record) {
  const ros::Time stamp = impl_->StampOf(frame.mid_exposure), delivered = impl_->StampOf(record.delivered);
  impl_->camera_info.header.stamp = stamp;
  impl_->WriteMessage("/camera/camera_info", delivered, impl_->camera_info);
  impl_->WriteMessage("/camera/image_raw", delivered, ImageOf(stamp, frame.image));
  if (record.status == estimator::FrameStatus::kOk) {
    impl_->WriteMessage("/estimate", delivered, EstimatedPose(stamp, record.pose.value()));
  }
}

void FlightBag::Finish(const runner::FlightLog& log) {
  // Small chunks: playback alternates between these and the chunks with frames, and reads each chunk as a whole.
  constexpr std::uint32_t kSmallChunk_bytes = 64 * 1024;
  impl_->Guarded([this] { impl_->bag->setChunkThreshold(kSmallChunk_bytes); });
  for (const auto& [tick, X_WB] : runner::TrueTrajectory(log)) impl_->WriteTruth(tick, X_WB);
  for (const auto& [tick, X_WB] : runner::TrackedTrajectory(log)) {
    impl_->WriteMessage("/tracking", impl_->StampOf(tick), BodyPose(impl_->StampOf(tick), X_WB));
  }
  impl_->Close();
  impl_->finished = true;
}

}  // namespace touchdown::datasets
