#include "scenarios/datasets/bag_file.h"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <array>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string_view>

#include "models/error.h"
#include "scenarios/datasets/bag_messages.h"
#include "scenarios/datasets/flight_bag.h"
#include "scenarios/datasets/flight_metadata.h"
#include "scenarios/datasets/gray_image.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCompressedImage = "sensor_msgs/CompressedImage";

/// Pixel layout of an image: its name in ROS and its OpenCV type.
struct Encoding {
  std::string_view name;
  int type;
  bool is_red_first = false;
};
constexpr std::array<Encoding, 10> kEncodings = {{{"mono8", CV_8UC1},
                                                  {"8UC1", CV_8UC1},
                                                  {"mono16", CV_16UC1},
                                                  {"16UC1", CV_16UC1},
                                                  {"bgr8", CV_8UC3},
                                                  {"8UC3", CV_8UC3},
                                                  {"rgb8", CV_8UC3, true},
                                                  {"bgra8", CV_8UC4},
                                                  {"8UC4", CV_8UC4},
                                                  {"rgba8", CV_8UC4, true}}};

const Encoding& FindEncoding(const std::string& name) {
  const auto* const found = std::find_if(kEncodings.begin(), kEncodings.end(),
                                         [&name](const Encoding& encoding) { return encoding.name == name; });
  if (found != kEncodings.end()) return *found;
  std::vector<std::string_view> names;
  for (const Encoding& encoding : kEncodings) names.push_back(encoding.name);
  throw InputError(fmt::format("unsupported image encoding {}; allowed: {}", name, fmt::join(names, ", ")));
}

models::Image GrayImage(const ros1::Image& message) {
  const Encoding& encoding = FindEncoding(message.encoding);
  constexpr std::uint32_t kLargestSide_px = 1 << 15;
  const std::uint64_t row = std::uint64_t{message.width} * CV_ELEM_SIZE(encoding.type);
  if (message.width == 0 || message.height == 0 || std::max(message.width, message.height) > kLargestSide_px ||
      message.step < row || message.step % CV_ELEM_SIZE1(encoding.type) != 0 ||
      message.data.size() < std::uint64_t{message.step} * message.height) {
    throw InputError(fmt::format("malformed image message of {} x {} px", message.width, message.height));
  }
  if (message.is_bigendian && CV_MAT_DEPTH(encoding.type) == CV_16U)
    throw InputError("16-bit image is big-endian; allowed: little-endian");
  cv::Mat image(static_cast<int>(message.height), static_cast<int>(message.width), encoding.type,
                const_cast<std::uint8_t*>(message.data.data()), message.step);
  if (!encoding.is_red_first) return ToGrayImage(image);
  cv::Mat blue_first;
  cv::cvtColor(image, blue_first, image.channels() == 4 ? cv::COLOR_RGBA2BGR : cv::COLOR_RGB2BGR);
  return ToGrayImage(blue_first);
}

models::Image GrayImage(const ros1::CompressedImage& message) {
  const std::vector<std::uint8_t> file(message.data.begin(), message.data.end());
  cv::Mat gray;
  try {
    gray = cv::imdecode(file, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    gray.release();
  }
  if (gray.empty()) throw InputError(fmt::format("cannot decode compressed image (format {})", message.format));
  return ToGrayImage(gray);
}

/// Camera model of rectified images, from the projection matrix P; nullopt when P is not set.
std::optional<models::CameraModel> RectifiedCameraOf(const ros1::CameraInfo& info) {
  if (info.P[0] == 0.0) return std::nullopt;
  return models::CameraModel{.width_px = static_cast<int>(info.width),
                             .height_px = static_cast<int>(info.height),
                             .fx_px = info.P[0],
                             .fy_px = info.P[5],
                             .cx_px = info.P[2],
                             .cy_px = info.P[6],
                             .k1 = 0.0,
                             .k2 = 0.0,
                             .p1 = 0.0,
                             .p2 = 0.0,
                             .k3 = 0.0};
}

/// Camera model of raw images, from K and D; nullopt when K is not set or the distortion model is not supported.
std::optional<models::CameraModel> CameraOf(const ros1::CameraInfo& info) {
  constexpr std::size_t kTerms = 5;
  if (info.K[0] == 0.0 || info.D.size() > kTerms) return std::nullopt;
  if (!info.D.empty() && info.distortion_model != "plumb_bob") return std::nullopt;
  std::array<double, kTerms> d{};
  std::copy(info.D.begin(), info.D.end(), d.begin());
  return models::CameraModel{.width_px = static_cast<int>(info.width),
                             .height_px = static_cast<int>(info.height),
                             .fx_px = info.K[0],
                             .fy_px = info.K[4],
                             .cx_px = info.K[2],
                             .cy_px = info.K[5],
                             .k1 = d[0],
                             .k2 = d[1],
                             .p1 = d[2],
                             .p2 = d[3],
                             .k3 = d[4]};
}

/// Topic of the CameraInfo of an image topic: camera_info in the same namespace, also for topics of image_transport.
std::string CameraInfoTopic(std::string image_topic) {
  constexpr std::string_view kCompressed = "/compressed";
  if (image_topic.ends_with(kCompressed)) image_topic.resize(image_topic.size() - kCompressed.size());
  return image_topic.substr(0, image_topic.rfind('/') + 1) + "camera_info";
}

/// Returns whether a topic has images rectified by image_proc, according to its name.
bool IsRectified(const std::string& image_topic) { return image_topic.find("/image_rect") != std::string::npos; }

/// Tree of the static transforms between frames, from /tf_static.
class FrameTree {
 public:
  void Add(const ros1::TFMessage& message) {
    for (const ros1::TransformStamped& transform : message.transforms) {
      const ros1::Vector3& p = transform.transform.translation;
      const ros1::Quaternion& q = transform.transform.rotation;
      Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
      X.translation() = Eigen::Vector3d(p.x, p.y, p.z);
      X.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
      parents_[WithoutSlash(transform.child_frame_id)] = {WithoutSlash(transform.header.frame_id), X};
    }
  }

  bool HasParent(const std::string& frame) const { return parents_.contains(WithoutSlash(frame)); }

  /// Pose of a frame on its body: the ancestor base_link, or the root of the tree when there is no such ancestor.
  struct PoseOnBody {
    std::string body;
    Eigen::Isometry3d X_BF = Eigen::Isometry3d::Identity();
  };
  PoseOnBody FindPoseOnBody(const std::string& frame) const {
    PoseOnBody pose{.body = WithoutSlash(frame)};
    for (std::size_t steps = 0; steps < parents_.size() && pose.body != "base_link"; ++steps) {
      const auto parent = parents_.find(pose.body);
      if (parent == parents_.end()) break;
      pose = {parent->second.frame, parent->second.X * pose.X_BF};
    }
    return pose;
  }

 private:
  struct Parent {
    std::string frame;
    Eigen::Isometry3d X;
  };
  /// Frame name without the leading slash of tf1.
  static std::string WithoutSlash(const std::string& frame) { return frame.starts_with('/') ? frame.substr(1) : frame; }

  std::map<std::string, Parent> parents_;
};

}  // namespace

struct BagFile::Impl {
  /// Calls `action`. Rethrows its InputError with the name of the bag, and any exception of the library as InputError.
  template <typename Action>
  auto WithFileInErrors(const Action& action) const {
    try {
      return action();
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const std::exception&) {  // Its message may contain bytes of the bag.
      throw InputError(fmt::format("{}: not a readable ROS bag, or truncated", file.string()));
    }
  }

  void Open(const std::vector<std::string>& wanted) {
    console_bridge::noOutputHandler();  // Errors are reported by exceptions.
    bag.open(file.string(), rosbag::bagmode::Read);
    rosbag::View all(bag);
    for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
      if (connection->datatype == "sensor_msgs/Image" || connection->datatype == kCompressedImage) {
        image_topics.insert(connection->topic);
      }
      if (connection->datatype == "sensor_msgs/Imu") imu_topics.insert(connection->topic);
    }
    for (const std::string& topic : wanted) {
      if (!image_topics.contains(topic) && !imu_topics.contains(topic)) {
        throw InputError(fmt::format("no images or IMU samples on topic {}", topic));
      }
    }
    if (image_topics.empty()) throw InputError("no image topic (sensor_msgs/Image or CompressedImage)");
    image_topic = SelectTopic(image_topics, wanted, "images");
    metadata.frame_order = estimator::FrameOrder::kSequence;
    ReadFlight();
    if (!imu_topics.empty()) ReadImu(SelectTopic(imu_topics, wanted, "IMU samples"));
    OpenImages();
    if (!metadata.camera) ReadCamera();
    if (!metadata.mounting) ReadMounting();
  }

  /// Returns the topic that is in `topics` and `wanted`, or the only one of `topics`. Throws InputError when ambiguous.
  static std::string SelectTopic(const std::set<std::string>& topics, const std::vector<std::string>& wanted,
                                 std::string_view what) {
    std::set<std::string> selected;
    std::copy_if(
        topics.begin(), topics.end(), std::inserter(selected, selected.end()),
        [&wanted](const std::string& topic) { return std::find(wanted.begin(), wanted.end(), topic) != wanted.end(); });
    if (selected.empty()) selected = topics;
    if (selected.size() == 1) return *selected.begin();
    throw InputError(
        fmt::format("several topics with {}; select one with --topic: {}", what, fmt::join(selected, ", ")));
  }

  template <typename Message>
  static boost::shared_ptr<Message> Read(const rosbag::MessageInstance& instance) {
    const auto message = instance.instantiate<Message>();
    if (!message) {
      throw InputError(fmt::format("topic {}: message does not match the ROS 1 definition of {}", instance.getTopic(),
                                   instance.getDataType()));
    }
    return message;
  }

  /// Calls `action` with each message of a topic and its recording time.
  template <typename Message, typename Action>
  void ForEach(const std::string& topic, const Action& action) const {
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& instance : view) action(*Read<Message>(instance), instance.getTime());
  }

  models::Tick TickOf(const ros::Time& time) const {
    return metadata.time.FromNanoseconds(static_cast<std::int64_t>(time.toNSec()) - epoch_ns);
  }
  models::Tick TickOf(const ros1::Header& header, const ros::Time& recorded) const {
    return TickOf(header.stamp.isZero() ? recorded : header.stamp);
  }

  void ReadFlight() {
    ForEach<ros1::String>(kScenarioTopic, [this](const ros1::String& text, const ros::Time&) {
      SetFlightMetadata(runner::ParseScenario(text.data, kScenarioTopic, {}), metadata);
      epoch_ns = kBagEpoch_ns;
    });
  }

  void ReadImu(const std::string& topic) {
    std::map<models::Tick, bool> at_rest;
    ForEach<ros1::Bool>(kAtRestTopic, [&](const ros1::Bool& flag, const ros::Time& recorded) {
      at_rest[TickOf(recorded)] = flag.data;
    });
    ForEach<ros1::Imu>(topic, [&](const ros1::Imu& imu, const ros::Time& recorded) {
      const models::Tick tick = TickOf(imu.header, recorded);
      if (!metadata.imu.empty() && tick <= metadata.imu.back().sample.tick)
        ThrowTimeOrderError(topic, metadata.imu.size());
      const auto change = at_rest.upper_bound(tick);
      const ros1::Vector3 &f = imu.linear_acceleration, &w = imu.angular_velocity;
      metadata.imu.push_back({.sample = {.tick = tick, .specific_force_U = {f.x, f.y, f.z}, .w_WU_U = {w.x, w.y, w.z}},
                              .at_rest = change != at_rest.begin() && std::prev(change)->second});
      imu_frame = imu.header.frame_id;
    });
  }

  [[noreturn]] static void ThrowTimeOrderError(const std::string& topic, std::size_t index) {
    throw InputError(
        fmt::format("topic {}: the time of message {} is not after that of the message before", topic, index));
  }

  void OpenImages() {
    images.addQuery(bag, rosbag::TopicQuery(image_topic));
    next_image = images.begin();
    if (images.size() == 0) throw InputError(fmt::format("topic {}: no messages", image_topic));
    metadata.frame_count = images.size();
    const double span_s = (images.getEndTime() - images.getBeginTime()).toSec();
    if (span_s > 0.0) metadata.frames_per_s = static_cast<double>(images.size() - 1) / span_s;
  }

  void ReadCamera() {
    rosbag::View view(bag, rosbag::TopicQuery(CameraInfoTopic(image_topic)));
    if (view.size() == 0) return;
    const auto info = Read<ros1::CameraInfo>(*view.begin());
    metadata.camera = IsRectified(image_topic) ? RectifiedCameraOf(*info) : CameraOf(*info);
    if (metadata.camera) metadata.camera->Validate();
  }

  void ReadMounting() {
    FrameTree tree;
    ForEach<ros1::TFMessage>("/tf_static",
                             [&tree](const ros1::TFMessage& message, const ros::Time&) { tree.Add(message); });
    const std::string camera_frame = HeaderOf(*next_image).frame_id;
    if (!tree.HasParent(camera_frame)) return;
    const FrameTree::PoseOnBody camera = tree.FindPoseOnBody(camera_frame);
    metadata.mounting = SensorMounting{.X_BC = camera.X_BF};
    if (metadata.imu.empty()) return;
    const FrameTree::PoseOnBody imu = tree.FindPoseOnBody(imu_frame);
    if (imu.body == camera.body) {
      metadata.mounting->X_BU = imu.X_BF;
    } else {
      metadata.mounting.reset();
    }
  }

  static bool IsCompressed(const rosbag::MessageInstance& instance) {
    return instance.getDataType() == kCompressedImage;
  }
  static ros1::Header HeaderOf(const rosbag::MessageInstance& instance) {
    return IsCompressed(instance) ? Read<ros1::CompressedImage>(instance)->header : Read<ros1::Image>(instance)->header;
  }

  template <typename Message>
  FootageFrame FrameOf(const rosbag::MessageInstance& instance) const {
    const auto message = Read<Message>(instance);
    return {file.filename().string(), TickOf(message->header, instance.getTime()), GrayImage(*message)};
  }

  std::optional<FootageFrame> Next() {
    if (next_image == images.end()) return std::nullopt;
    FootageFrame frame =
        IsCompressed(*next_image) ? FrameOf<ros1::CompressedImage>(*next_image) : FrameOf<ros1::Image>(*next_image);
    if (previous_time && *frame.mid_exposure <= *previous_time) ThrowTimeOrderError(image_topic, read);
    previous_time = frame.mid_exposure;
    ++next_image;
    ++read;
    return frame;
  }

  fs::path file;
  FootageMetadata metadata;
  rosbag::Bag bag;
  std::set<std::string> image_topics, imu_topics;
  std::string image_topic, imu_frame;
  std::int64_t epoch_ns = 0;
  rosbag::View images;
  rosbag::View::iterator next_image;
  std::optional<models::Tick> previous_time;
  std::size_t read = 0;
};

BagFile::BagFile(const fs::path& file, const std::vector<std::string>& topics) : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->WithFileInErrors([&] { impl_->Open(topics); });
}

BagFile::~BagFile() = default;

const FootageMetadata& BagFile::metadata() const { return impl_->metadata; }

std::optional<FootageFrame> BagFile::Next() {
  return impl_->WithFileInErrors([this] { return impl_->Next(); });
}

}  // namespace touchdown::datasets
