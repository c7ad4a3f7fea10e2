# Finds what reads and writes ROS 1 bags: the target Rosbag::Rosbag. Debian's packages of ROS have CMake files that ask
# for each other's catkin, and headers in folders of their own, so that both are looked for by hand.
set(rosbag_libraries rosbag_storage rostime cpp_common roscpp_serialization class_loader rcutils ament_index_cpp
  console_bridge)
set(rosbag_headers rosbag/bag.h sensor_msgs/Image.h geometry_msgs/PoseStamped.h tf2_msgs/TFMessage.h std_msgs/String.h
  pluginlib/class_loader.hpp class_loader/class_loader.hpp rcutils/logging_macros.h rcpputils/shared_library.hpp
  ament_index_cpp/get_resource.hpp)

set(rosbag_required "")
set(rosbag_include_dirs "")
foreach(library ${rosbag_libraries})
  find_library(Rosbag_${library}_LIBRARY ${library})
  mark_as_advanced(Rosbag_${library}_LIBRARY)
  list(APPEND rosbag_required Rosbag_${library}_LIBRARY)
endforeach()
foreach(header ${rosbag_headers})
  get_filename_component(package ${header} DIRECTORY)
  find_path(Rosbag_${package}_INCLUDE_DIR ${header} PATH_SUFFIXES ${package})
  mark_as_advanced(Rosbag_${package}_INCLUDE_DIR)
  list(APPEND rosbag_required Rosbag_${package}_INCLUDE_DIR)
  list(APPEND rosbag_include_dirs ${Rosbag_${package}_INCLUDE_DIR})
endforeach()
list(REMOVE_DUPLICATES rosbag_include_dirs)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Rosbag REQUIRED_VARS ${rosbag_required})

if(Rosbag_FOUND AND NOT TARGET Rosbag::Rosbag)
  add_library(Rosbag::Rosbag INTERFACE IMPORTED)
  target_include_directories(Rosbag::Rosbag SYSTEM INTERFACE ${rosbag_include_dirs})
  foreach(library ${rosbag_libraries})
    target_link_libraries(Rosbag::Rosbag INTERFACE ${Rosbag_${library}_LIBRARY})
  endforeach()
endif()
