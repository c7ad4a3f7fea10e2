# find_package(Touchdown) gives a vehicle touchdown::models, touchdown::estimator and touchdown::controller: no MuJoCo.
include(CMakePackageConfigHelpers)

set(TOUCHDOWN_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Touchdown)

install(TARGETS touchdown_models touchdown_estimator_base touchdown_estimator_pad touchdown_estimator_paper
  touchdown_estimator_calibration touchdown_estimator touchdown_controller EXPORT TouchdownTargets
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT TouchdownTargets NAMESPACE touchdown:: DESTINATION ${TOUCHDOWN_PACKAGE_DIR})
install(CODE "execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
  -D DESTINATION=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}
  -P ${CMAKE_CURRENT_LIST_DIR}/install_headers.cmake COMMAND_ERROR_IS_FATAL ANY)")

write_basic_package_version_file(${PROJECT_BINARY_DIR}/TouchdownConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/TouchdownConfig.cmake ${PROJECT_BINARY_DIR}/TouchdownConfigVersion.cmake
  DESTINATION ${TOUCHDOWN_PACKAGE_DIR})
