include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
find_dependency(OpenCV 4.5 COMPONENTS core imgproc)
include(${CMAKE_CURRENT_LIST_DIR}/TouchdownTargets.cmake)
