#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <type_traits>

/// ROS message types. Only the files that read and write bags include this header. ROS requires an allocator with a
/// member `rebind`, which C++20 removed from std::allocator; the allocator below adds it. Strings keep std::allocator.
namespace touchdown::datasets::ros1 {

template <typename T>
struct Rebindable : std::allocator<T> {
  template <typename U>
  struct rebind {  // NOLINT: name required by the allocator interface.
    using other = std::conditional_t<std::is_same_v<U, char>, std::allocator<char>, Rebindable<U>>;
  };
};
using Allocator = Rebindable<void>;

using Bool = std_msgs::Bool_<Allocator>;
using CameraInfo = sensor_msgs::CameraInfo_<Allocator>;
using CompressedImage = sensor_msgs::CompressedImage_<Allocator>;
using Header = std_msgs::Header_<Allocator>;
using Image = sensor_msgs::Image_<Allocator>;
using Imu = sensor_msgs::Imu_<Allocator>;
using Point = geometry_msgs::Point_<Allocator>;
using Pose = geometry_msgs::Pose_<Allocator>;
using PoseStamped = geometry_msgs::PoseStamped_<Allocator>;
using PoseWithCovarianceStamped = geometry_msgs::PoseWithCovarianceStamped_<Allocator>;
using Quaternion = geometry_msgs::Quaternion_<Allocator>;
using String = std_msgs::String_<Allocator>;
using TFMessage = tf2_msgs::TFMessage_<Allocator>;
using TransformStamped = geometry_msgs::TransformStamped_<Allocator>;
using Vector3 = geometry_msgs::Vector3_<Allocator>;

}  // namespace touchdown::datasets::ros1
