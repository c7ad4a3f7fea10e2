# cmake -D NODE=node -D MODULES=node_modules -D OUT=folder -P bundle.cmake
# Bundles the script and the style sheet of the page with esbuild, from the files in this folder and from uPlot. Writes
# the bundle and the license of uPlot to OUT.
if(NOT NODE)
  message(FATAL_ERROR "node is missing; it is required to bundle the page. On Debian: apt-get install nodejs npm")
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${MODULES} ${NODE} ${MODULES}/esbuild/bin/esbuild main.js page.css
    --bundle --minify --legal-comments=none --target=es2022,chrome110,firefox115,safari16 --charset=utf8
    --outdir=${OUT} --log-level=warning
  WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR} COMMAND_ERROR_IS_FATAL ANY)
configure_file(${MODULES}/uplot/LICENSE ${OUT}/uPlot.LICENSE COPYONLY)
