# kanexpr_add_harness(<name> <engine>): what all tests link. `engine` is kanexpr where every test compiles it.
function(kanexpr_add_harness name engine)
  add_library(${name} STATIC oracles.cpp no_heap.cpp systems/hand_written.cpp systems/linearized.cpp
    systems/newton_euler.cpp systems/robot_results.cpp)
  target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/examples)
  target_compile_definitions(${name} PRIVATE KANEXPR_ORACLES="${CMAKE_CURRENT_SOURCE_DIR}/oracles")
  # Results of two compilers are compared to the last bit: none of them may fuse a product and a sum.
  target_compile_options(${name} PUBLIC -ffp-contract=off)
  target_link_libraries(${name} PUBLIC ${engine} kanexpr_strict GTest::gmock GTest::gtest_main
    PRIVATE nlohmann_json::nlohmann_json)
  # Eigen asks malloc itself for memory: replacing operator new would not see it.
  target_link_options(${name} INTERFACE
    LINKER:--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=aligned_alloc,--wrap=posix_memalign)
endfunction()

# kanexpr_precompile(<harness>): compiles what nearly every test includes once for the tests that link the harness.
function(kanexpr_precompile harness)
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")
  add_library(${harness}_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${harness}_headers PRIVATE ${harness})
  target_precompile_headers(${harness}_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <kanexpr/symbolic.hpp>)
endfunction()

# kanexpr_test(<name> SOURCES <file>... LABELS <build>...): one GoogleTest program, registered as one test.
function(kanexpr_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "" "SOURCES;LABELS")
  add_executable(${name} ${test_SOURCES})
  set(harness kanexpr_harness)
  if(KANEXPR_SANITIZERS AND "sanitize" IN_LIST test_LABELS)
    set(harness kanexpr_harness_sanitized)
  endif()
  target_link_libraries(${name} PRIVATE ${harness})
  target_precompile_headers(${name} REUSE_FROM ${harness}_headers)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${test_LABELS}")
endfunction()

# A test says in its own text which of the special builds it takes part in: `// builds: sanitize no-exceptions`.
function(kanexpr_test_builds file result)
  file(STRINGS ${file} builds REGEX "^// builds: " LIMIT_COUNT 1)
  string(REPLACE "// builds: " "" builds "${builds}")
  separate_arguments(builds)
  set(${result} ${builds} PARENT_SCOPE)
endfunction()

# kanexpr_headers_alone(<name> [EVERY] [ONLY <regex>] [EXCEPT <regex>]): compiles public headers alone, and twice in one
# file. What another of them includes before anything else is compiled alone with that one, and left out but for EVERY.
function(kanexpr_headers_alone name)
  cmake_parse_arguments(PARSE_ARGV 1 headers "EVERY" "ONLY;EXCEPT" "")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
    ${PROJECT_SOURCE_DIR}/include/*.hpp)
  if(headers_ONLY)
    list(FILTER headers INCLUDE REGEX ${headers_ONLY})
  endif()
  if(headers_EXCEPT)
    list(FILTER headers EXCLUDE REGEX ${headers_EXCEPT})
  endif()
  set(included_first)
  foreach(header IN LISTS headers)
    file(READ ${PROJECT_SOURCE_DIR}/include/${header} text)
    if(NOT text MATCHES "^(//[^\n]*\n|\n)*#pragma once\n(//[^\n]*\n|\n)*(#include <([^>]+)>)?")
      message(FATAL_ERROR "${header} does not begin with #pragma once")
    endif()
    list(APPEND included_first ${CMAKE_MATCH_4})
  endforeach()
  if(NOT headers_EVERY)
    list(REMOVE_ITEM headers ${included_first})
  endif()
  add_library(${name} OBJECT)
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "\\.hpp$" ".cpp" source ${name}/${header})
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
    target_sources(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${source})
  endforeach()
  target_link_libraries(${name} PRIVATE kanexpr kanexpr_simulate kanexpr_animate kanexpr_robots_sdf kanexpr_strict)
  target_compile_options(${name} PRIVATE -O0)
endfunction()
