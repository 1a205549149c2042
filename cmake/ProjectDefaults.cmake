# SPDX-License-Identifier: GPL-3.0-or-later
# What every target of this project shares, as functions that targets call: no global flags.

if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

option(ANISO_WARNINGS_AS_ERRORS "Fail on compiler warnings (CI does)" OFF)
set(ANISO_SANITIZE "" CACHE STRING "Sanitizers for every target, as in -fsanitize=; empty for none")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

function(aniso_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)
  if(MSVC)  # and compilers that take its options
    target_compile_options(${target} PRIVATE /W4 /utf-8 /bigobj /Zc:__cplusplus /fp:precise
      $<$<BOOL:${ANISO_WARNINGS_AS_ERRORS}>:/WX>)
  else()
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
      $<$<CXX_COMPILER_ID:Clang>:-Wno-gnu-zero-variadic-macro-arguments>  # GoogleTest's macros in standard C++17
      $<$<BOOL:${ANISO_WARNINGS_AS_ERRORS}>:-Werror>)
    # Products and sums are fused where the code says so and nowhere else: compilers differ in where they would.
    target_compile_options(${target} PRIVATE -ffp-contract=off)
  endif()
  if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # The linker keeps one of the copies of an inline function that GCC has changed for its callers in each file, by name
    # alone, though they take other arguments and use other registers.
    target_compile_options(${target} PRIVATE -fno-ipa-sra -fno-ipa-cp-clone -fno-partial-inlining -fno-ipa-ra)
  endif()
  if(WIN32)  # no macros min and max; M_PI, which vcglib uses
    target_compile_definitions(${target} PRIVATE NOMINMAX WIN32_LEAN_AND_MEAN _USE_MATH_DEFINES)
  endif()
  if(ANISO_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${ANISO_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${ANISO_SANITIZE})
  endif()
endfunction()

# For programs of tests, which take longer to compile than to run: what they test is optimised in full, they are not.
function(aniso_test_defaults target)
  aniso_target_defaults(${target})
  if(ANISO_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  elseif(NOT MSVC)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# Compiles headers of other libraries that most sources of a target include once for all of them. Sources name all the
# same what they use: they are compiled without this as well (scripts/tidy).
function(aniso_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  # For ccache, which has to tell one precompiled header from another.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()
