# Bundles the script and the style sheet and compares the result byte by byte with the committed bundle.
#   cmake -D NODE=... -D MODULES=... -D WEB_DIR=... -D WORK_DIR=... -P web_bundle.cmake
if(NOT NODE OR NOT EXISTS ${MODULES}/esbuild)
  message("Skipped: Node.js or the npm packages are missing")
  return()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
execute_process(COMMAND ${CMAKE_COMMAND} -D NODE=${NODE} -D MODULES=${MODULES} -D OUT=${WORK_DIR}
  -P ${WEB_DIR}/bundle.cmake COMMAND_ERROR_IS_FATAL ANY)
foreach(file main.js page.css uPlot.LICENSE)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK_DIR}/${file} ${WEB_DIR}/dist/${file}
    RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "${WEB_DIR}/dist/${file} is out of date; run `ninja web_bundle` to update it")
  endif()
endforeach()
