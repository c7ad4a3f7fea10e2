# find_package(Touchdown) gives a vehicle touchdown::models, touchdown::estimator and touchdown::controller: no MuJoCo.
include(CMakePackageConfigHelpers)

set(TOUCHDOWN_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Touchdown)

get_property(libraries GLOBAL PROPERTY TOUCHDOWN_MODULES)
list(FILTER libraries INCLUDE REGEX "^touchdown_(models|estimator|controller)")
install(TARGETS ${libraries} EXPORT TouchdownTargets
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT TouchdownTargets NAMESPACE touchdown:: DESTINATION ${TOUCHDOWN_PACKAGE_DIR})
install(CODE "execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
  -D DESTINATION=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}
  -P ${CMAKE_CURRENT_LIST_DIR}/install_headers.cmake COMMAND_ERROR_IS_FATAL ANY)")

write_basic_package_version_file(${PROJECT_BINARY_DIR}/TouchdownConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/TouchdownConfig.cmake ${PROJECT_BINARY_DIR}/TouchdownConfigVersion.cmake
  DESTINATION ${TOUCHDOWN_PACKAGE_DIR})
