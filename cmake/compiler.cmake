# The compiler, its options, and what is recorded of them.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# The determinism contract: no contraction of a * b + c, whatever the compiler's default.
add_compile_options(-Wall -Wextra -ffp-contract=off)

if(DEVO_EVO_SANITIZE)
  add_compile_options(-fsanitize=${DEVO_EVO_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${DEVO_EVO_SANITIZE})
endif()

if(DEVO_EVO_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

find_program(CCACHE ccache)
mark_as_advanced(CCACHE)
if(CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# The source that defines devo_evo::buildInfo(): version, commit and compiler, looked up at every build.
set(build_constants ${CMAKE_CURRENT_BINARY_DIR}/build_constants.cpp)
string(TOUPPER ${CMAKE_BUILD_TYPE} build_type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" flags)
add_custom_target(devo_evo_build_info
  COMMAND ${CMAKE_COMMAND}
    -D SOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR}
    -D TEMPLATE=${CMAKE_CURRENT_SOURCE_DIR}/src/experiment/build_constants.cpp.in
    -D OUTPUT=${build_constants}
    -D VERSION=${PROJECT_VERSION}
    -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE} (${flags})"
    -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/build_info.cmake
  BYPRODUCTS ${build_constants}
  COMMENT "Looking up the commit"
  VERBATIM)
