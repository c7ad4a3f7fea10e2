# Installs the project into WORK_DIR, builds a program with the flight libraries outside the source tree, and runs both
# programs.
#   cmake -D BUILD_DIR=... -D SOURCE_DIR=... -D WORK_DIR=... -D BUILD_TYPE=... -D CXX_FLAGS=... -P run.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE_DIR} -B ${WORK_DIR}/build -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix
  -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)
if(EXISTS ${BUILD_DIR}/touchdown)
  run(${WORK_DIR}/prefix/bin/touchdown --version)
endif()

execute_process(COMMAND ldd ${WORK_DIR}/build/consumer OUTPUT_VARIABLE libraries COMMAND_ERROR_IS_FATAL ANY)
if(libraries MATCHES "mujoco|OSMesa|yaml")
  message(FATAL_ERROR "the flight libraries must not link the simulation:\n${libraries}")
endif()
file(GLOB_RECURSE headers ${WORK_DIR}/prefix/*.h)
foreach(header IN LISTS headers)
  file(READ ${header} text)
  if(text MATCHES "opencv2/|mujoco/")
    message(FATAL_ERROR "${header} includes OpenCV or MuJoCo")
  endif()
endforeach()
