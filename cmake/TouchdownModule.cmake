# What every target of the project shares: the language, the warnings, floating point that does not depend on which
# instructions the compiler fuses, and calls within a library inlined although its code is position independent.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

add_library(touchdown_options INTERFACE)
target_compile_options(touchdown_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> -ffp-contract=off -fno-semantic-interposition $<$<BOOL:${TOUCHDOWN_WERROR}>:-Werror>)

# touchdown_module(NAME [FOLDERS folder...] [SOURCES file...] [EXCLUDE file...] [HEADERS file...]
#   PUBLIC lib... PRIVATE lib...)
#
# Adds a module: the static library touchdown_NAME, its alias touchdown::NAME, made of every source in this folder (and
# in FOLDERS within it), or of SOURCES alone, without EXCLUDE. A new file needs no line here.
#
# PUBLIC and PRIVATE are the libraries that its headers and its sources may use, and the only ones that they can: the
# headers of a module are found through its own target, so an include of any other module does not compile. Includes are
# written from the root of the project ("models/time.h").
function(touchdown_module name)
  cmake_parse_arguments(ARG "" "" "FOLDERS;SOURCES;HEADERS;EXCLUDE;PUBLIC;PRIVATE" ${ARGN})
  list(TRANSFORM ARG_FOLDERS APPEND "/")
  if(NOT ARG_SOURCES)
    foreach(folder IN LISTS ARG_FOLDERS ITEMS "")
      file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${folder}*.cc ${folder}*.c)
      file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${folder}*.h)
      list(APPEND ARG_SOURCES ${sources})
      list(APPEND ARG_HEADERS ${headers})
    endforeach()
    list(REMOVE_ITEM ARG_SOURCES "" ${ARG_EXCLUDE})
  endif()

  add_library(touchdown_${name} STATIC ${ARG_SOURCES})
  add_library(touchdown::${name} ALIAS touchdown_${name})
  set_property(GLOBAL APPEND PROPERTY TOUCHDOWN_MODULES touchdown_${name})
  target_compile_features(touchdown_${name} PUBLIC cxx_std_20)
  target_link_libraries(touchdown_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:touchdown_options>)
  set_target_properties(touchdown_${name} PROPERTIES EXPORT_NAME ${name})

  set(include_dir ${PROJECT_BINARY_DIR}/include/${name})
  file(RELATIVE_PATH place ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  file(REMOVE_RECURSE ${include_dir})
  foreach(header IN LISTS ARG_HEADERS)
    cmake_path(GET header PARENT_PATH folder)
    file(MAKE_DIRECTORY ${include_dir}/${place}/${folder})
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/${header} ${include_dir}/${place}/${header} SYMBOLIC)
  endforeach()
  target_include_directories(touchdown_${name} PUBLIC $<BUILD_INTERFACE:${include_dir}>)
endfunction()
