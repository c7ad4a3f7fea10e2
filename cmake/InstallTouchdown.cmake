# find_package(Touchdown) gives a vehicle touchdown::models, touchdown::estimator and touchdown::controller: no MuJoCo.
include(CMakePackageConfigHelpers)

set(TOUCHDOWN_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Touchdown)
set(TOUCHDOWN_HEADER_DIR ${CMAKE_INSTALL_INCLUDEDIR}/touchdown)

install(TARGETS touchdown_models touchdown_estimator touchdown_controller EXPORT TouchdownTargets)
install(EXPORT TouchdownTargets NAMESPACE touchdown:: DESTINATION ${TOUCHDOWN_PACKAGE_DIR})
install(DIRECTORY models controller DESTINATION ${TOUCHDOWN_HEADER_DIR} FILES_MATCHING PATTERN "*.h")
install(DIRECTORY estimator DESTINATION ${TOUCHDOWN_HEADER_DIR} FILES_MATCHING PATTERN "*.h" PATTERN paper EXCLUDE)
install(FILES estimator/paper/paper_options.h DESTINATION ${TOUCHDOWN_HEADER_DIR}/estimator/paper)

write_basic_package_version_file(${PROJECT_BINARY_DIR}/TouchdownConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/TouchdownConfig.cmake ${PROJECT_BINARY_DIR}/TouchdownConfigVersion.cmake
  DESTINATION ${TOUCHDOWN_PACKAGE_DIR})
