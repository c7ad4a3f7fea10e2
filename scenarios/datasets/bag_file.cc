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
#include "scenarios/datasets/flight_facts.h"
#include "scenarios/datasets/gray_image.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCompressedImage = "sensor_msgs/CompressedImage";

/// How ROS calls the layout of a picture's pixels, and how OpenCV does.
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
  throw InputError(fmt::format("has the encoding {}, which is none of {}", name, fmt::join(names, ", ")));
}

models::Image GrayImage(const ros1::Image& message) {
  const Encoding& encoding = FindEncoding(message.encoding);
  constexpr std::uint32_t kLargestSide_px = 1 << 15;
  const std::uint64_t row = std::uint64_t{message.width} * CV_ELEM_SIZE(encoding.type);
  if (message.width == 0 || message.height == 0 || std::max(message.width, message.height) > kLargestSide_px ||
      message.step < row || message.step % CV_ELEM_SIZE1(encoding.type) != 0 ||
      message.data.size() < std::uint64_t{message.step} * message.height) {
    throw InputError(fmt::format("is no picture of {} x {} px", message.width, message.height));
  }
  if (message.is_bigendian && CV_MAT_DEPTH(encoding.type) == CV_16U) throw InputError("is of big-endian numbers");
  cv::Mat picture(static_cast<int>(message.height), static_cast<int>(message.width), encoding.type,
                  const_cast<std::uint8_t*>(message.data.data()), message.step);
  if (!encoding.is_red_first) return ToGrayImage(picture);
  cv::Mat blue_first;
  cv::cvtColor(picture, blue_first, picture.channels() == 4 ? cv::COLOR_RGBA2BGR : cv::COLOR_RGB2BGR);
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
  if (gray.empty()) throw InputError(fmt::format("is no picture ({}) that can be read", message.format));
  return ToGrayImage(gray);
}

/// Of pictures that were rectified.
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

/// nullopt where it is not calibrated, or of another model than CameraModel's.
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

/// The topic of a picture's calibration: its sibling, also of what image_transport has compressed.
std::string CameraInfoTopic(std::string image_topic) {
  constexpr std::string_view kCompressed = "/compressed";
  if (image_topic.ends_with(kCompressed)) image_topic.resize(image_topic.size() - kCompressed.size());
  return image_topic.substr(0, image_topic.rfind('/') + 1) + "camera_info";
}

/// Whether image_proc has rectified the pictures of a topic.
bool IsRectified(const std::string& image_topic) { return image_topic.find("/image_rect") != std::string::npos; }

/// Frames and where they sit on others, from /tf_static.
class FrameTree {
 public:
  void Add(const ros1::TFMessage& message) {
    for (const ros1::TransformStamped& transform : message.transforms) {
      const ros1::Vector3& p = transform.transform.translation;
      const ros1::Quaternion& q = transform.transform.rotation;
      Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
      X.translation() = Eigen::Vector3d(p.x, p.y, p.z);
      X.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
      parents_[Plain(transform.child_frame_id)] = {Plain(transform.header.frame_id), X};
    }
  }

  bool IsOnAnother(const std::string& frame) const { return parents_.contains(Plain(frame)); }

  /// A frame's pose on its body: base_link where it is above it, else the topmost.
  struct Place {
    std::string body;
    Eigen::Isometry3d X_BF = Eigen::Isometry3d::Identity();
  };
  Place PlaceOf(const std::string& frame) const {
    Place place{.body = Plain(frame)};
    for (std::size_t steps = 0; steps < parents_.size() && place.body != "base_link"; ++steps) {
      const auto parent = parents_.find(place.body);
      if (parent == parents_.end()) break;
      place = {parent->second.frame, parent->second.X * place.X_BF};
    }
    return place;
  }

 private:
  struct Parent {
    std::string frame;
    Eigen::Isometry3d X;
  };
  /// ROS's earlier transforms begin names with a slash.
  static std::string Plain(const std::string& frame) { return frame.starts_with('/') ? frame.substr(1) : frame; }

  std::map<std::string, Parent> parents_;
};

}  // namespace

struct BagFile::Impl {
  /// Throws InputError, naming the bag, for what the library throws, and what `action` says of a message.
  template <typename Action>
  auto Try(const Action& action) const {
    try {
      return action();
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const std::exception&) {  // The library's words quote a damaged bag's bytes.
      throw InputError(fmt::format("{}: no ROS bag that can be read, or one that is cut", file.string()));
    }
  }

  void Open(const std::vector<std::string>& wanted) {
    console_bridge::noOutputHandler();  // What goes wrong is thrown.
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
        throw InputError(fmt::format("has no pictures or IMU's samples under the topic {}", topic));
      }
    }
    if (image_topics.empty()) throw InputError("has no topic of pictures (sensor_msgs/Image or CompressedImage)");
    image_topic = Choose(image_topics, wanted, "pictures");
    facts.frame_order = estimator::FrameOrder::kSequence;
    ReadFlight();
    if (!imu_topics.empty()) ReadImu(Choose(imu_topics, wanted, "an IMU's samples"));
    OpenImages();
    if (!facts.camera) ReadCamera();
    if (!facts.mounting) ReadMounting();
  }

  /// The one of `topics` that is wanted, or the only one.
  static std::string Choose(const std::set<std::string>& topics, const std::vector<std::string>& wanted,
                            std::string_view what) {
    std::set<std::string> left;
    std::copy_if(topics.begin(), topics.end(), std::inserter(left, left.end()), [&wanted](const std::string& topic) {
      return std::find(wanted.begin(), wanted.end(), topic) != wanted.end();
    });
    if (left.empty()) left = topics;
    if (left.size() == 1) return *left.begin();
    throw InputError(fmt::format("has several topics of {}; choose one with --topic: {}", what, fmt::join(left, ", ")));
  }

  template <typename Message>
  static boost::shared_ptr<Message> Read(const rosbag::MessageInstance& instance) {
    const auto message = instance.instantiate<Message>();
    if (!message) {
      throw InputError(fmt::format("topic {}: is no {} as ROS has it", instance.getTopic(), instance.getDataType()));
    }
    return message;
  }

  /// Calls `take` with every message of a topic, and the time when it was recorded.
  template <typename Message, typename Take>
  void ForEach(const std::string& topic, const Take& take) const {
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& instance : view) take(*Read<Message>(instance), instance.getTime());
  }

  models::Tick TickOf(const ros::Time& time) const {
    return facts.time.FromNanoseconds(static_cast<std::int64_t>(time.toNSec()) - epoch_ns);
  }
  models::Tick TickOf(const ros1::Header& header, const ros::Time& recorded) const {
    return TickOf(header.stamp.isZero() ? recorded : header.stamp);
  }

  void ReadFlight() {
    ForEach<ros1::String>(kScenarioTopic, [this](const ros1::String& text, const ros::Time&) {
      DescribeFlight(runner::ParseScenario(text.data, kScenarioTopic, {}), facts);
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
      if (!facts.imu.empty() && tick <= facts.imu.back().sample.tick) RefuseOrder(topic, facts.imu.size());
      const auto change = at_rest.upper_bound(tick);
      const ros1::Vector3 &f = imu.linear_acceleration, &w = imu.angular_velocity;
      facts.imu.push_back({.sample = {.tick = tick, .specific_force_U = {f.x, f.y, f.z}, .w_WU_U = {w.x, w.y, w.z}},
                           .at_rest = change != at_rest.begin() && std::prev(change)->second});
      imu_frame = imu.header.frame_id;
    });
  }

  [[noreturn]] static void RefuseOrder(const std::string& topic, std::size_t index) {
    throw InputError(fmt::format("topic {}: the time of message {} is not after the one before", topic, index));
  }

  void OpenImages() {
    images.addQuery(bag, rosbag::TopicQuery(image_topic));
    next_image = images.begin();
    if (images.size() == 0) throw InputError(fmt::format("topic {}: has no messages", image_topic));
    facts.frame_count = images.size();
    const double span_s = (images.getEndTime() - images.getBeginTime()).toSec();
    if (span_s > 0.0) facts.frames_per_s = static_cast<double>(images.size() - 1) / span_s;
  }

  void ReadCamera() {
    rosbag::View view(bag, rosbag::TopicQuery(CameraInfoTopic(image_topic)));
    if (view.size() == 0) return;
    const auto info = Read<ros1::CameraInfo>(*view.begin());
    facts.camera = IsRectified(image_topic) ? RectifiedCameraOf(*info) : CameraOf(*info);
    if (facts.camera) facts.camera->Validate();
  }

  void ReadMounting() {
    FrameTree tree;
    ForEach<ros1::TFMessage>("/tf_static",
                             [&tree](const ros1::TFMessage& message, const ros::Time&) { tree.Add(message); });
    const std::string camera_frame = HeaderOf(*next_image).frame_id;
    if (!tree.IsOnAnother(camera_frame)) return;
    const FrameTree::Place camera = tree.PlaceOf(camera_frame);
    facts.mounting = SensorMounting{.X_BC = camera.X_BF};
    if (facts.imu.empty()) return;
    const FrameTree::Place imu = tree.PlaceOf(imu_frame);
    if (imu.body == camera.body) {
      facts.mounting->X_BU = imu.X_BF;
    } else {
      facts.mounting.reset();
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
    if (newest && *frame.mid_exposure <= *newest) RefuseOrder(image_topic, read);
    newest = frame.mid_exposure;
    ++next_image;
    ++read;
    return frame;
  }

  fs::path file;
  FootageFacts facts;
  rosbag::Bag bag;
  std::set<std::string> image_topics, imu_topics;
  std::string image_topic, imu_frame;
  std::int64_t epoch_ns = 0;
  rosbag::View images;
  rosbag::View::iterator next_image;
  std::optional<models::Tick> newest;
  std::size_t read = 0;
};

BagFile::BagFile(const fs::path& file, const std::vector<std::string>& topics) : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->Try([&] { impl_->Open(topics); });
}

BagFile::~BagFile() = default;

const FootageFacts& BagFile::facts() const { return impl_->facts; }

std::optional<FootageFrame> BagFile::Next() {
  return impl_->Try([this] { return impl_->Next(); });
}

}  // namespace touchdown::datasets
