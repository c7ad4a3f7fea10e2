# cmake -D NPM=npm -D SOURCE_DIR=... -D BUILD_DIR=... -P fetch.cmake
# Installs exactly the packages of package-lock.json in BUILD_DIR/node_modules. Does nothing when they are installed.
set(stamp ${BUILD_DIR}/node_modules/.package-lock.sha256)
file(SHA256 ${SOURCE_DIR}/package-lock.json wanted)
if(EXISTS ${stamp})
  file(READ ${stamp} fetched)
  if(fetched STREQUAL wanted)
    return()
  endif()
endif()
if(NOT NPM)
  message(FATAL_ERROR
    "npm is missing; it is required to fetch the packages of the page. On Debian: apt-get install nodejs npm")
endif()
file(COPY ${SOURCE_DIR}/package.json ${SOURCE_DIR}/package-lock.json DESTINATION ${BUILD_DIR})
execute_process(COMMAND ${NPM} ci --ignore-scripts --prefer-offline --no-audit --no-fund --loglevel=error
  WORKING_DIRECTORY ${BUILD_DIR} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message("${output}")
  message(FATAL_ERROR "npm could not fetch the packages of the page (uPlot, esbuild, playwright-core); it requires "
    "access to its registry, or the packages in its cache")
endif()
file(WRITE ${stamp} ${wanted})
