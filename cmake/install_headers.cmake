# Installs the headers of the flight libraries below include/touchdown, with includes to match: "models/time.h" becomes
# <touchdown/models/time.h>, so that a program may have folders of the same names.
#   cmake -D SOURCE_DIR=... -D DESTINATION=... -P install_headers.cmake
foreach(module models controller estimator)
  file(GLOB_RECURSE headers RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${module}/*.h)
  list(FILTER headers EXCLUDE REGEX "^estimator/paper/")
  if(module STREQUAL estimator)
    list(APPEND headers estimator/paper/paper_options.h)
  endif()
  foreach(header IN LISTS headers)
    file(READ ${SOURCE_DIR}/${header} text)
    string(REGEX REPLACE "#include \"((models|controller|estimator)/[^\"]+)\"" "#include <touchdown/\\1>" text "${text}")
    file(WRITE ${DESTINATION}/touchdown/${header} "${text}")
  endforeach()
endforeach()
