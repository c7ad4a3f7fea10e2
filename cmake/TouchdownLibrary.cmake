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

# touchdown_library(models) gives the target touchdown_models its alias touchdown::models, includes written from the
# root, and the project's options.
function(touchdown_library name)
  add_library(touchdown::${name} ALIAS touchdown_${name})
  target_link_libraries(touchdown_${name} PRIVATE $<BUILD_INTERFACE:touchdown_options>)
  target_compile_features(touchdown_${name} PUBLIC cxx_std_20)
  target_include_directories(touchdown_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/touchdown>)
  set_target_properties(touchdown_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()
