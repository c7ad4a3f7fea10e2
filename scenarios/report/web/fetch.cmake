# cmake -D NPM=npm -D OPTIONS="..." -D SOURCE_DIR=... -D BUILD_DIR=... -P fetch.cmake: exactly the packages of
# package-lock.json, into BUILD_DIR/node_modules.
file(COPY ${SOURCE_DIR}/package.json ${SOURCE_DIR}/package-lock.json DESTINATION ${BUILD_DIR})
separate_arguments(OPTIONS)
execute_process(COMMAND ${NPM} ci ${OPTIONS} WORKING_DIRECTORY ${BUILD_DIR} RESULT_VARIABLE status
  OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message("${output}")
  message(FATAL_ERROR "npm could not fetch what the page of a flight's report is made with (uPlot, esbuild): it needs "
    "its registry, or these packages in its cache")
endif()
file(TOUCH ${BUILD_DIR}/node_modules/.package-lock.json)
