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

# A test says in its own text which of the special builds it takes part in, `// builds: sanitize no-exceptions`, and
# whether one compiler alone builds it, `// builds: g++`.
function(kanexpr_test_builds file result)
  file(STRINGS ${file} builds REGEX "^// builds: " LIMIT_COUNT 1)
  string(REPLACE "// builds: " "" builds "${builds}")
  separate_arguments(builds)
  set(${result} ${builds} PARENT_SCOPE)
endfunction()

# kanexpr_headers_alone(<name> [ONLY <regex>] [EXCEPT <regex>]): compiles every public header as the first of a file.
#
# Files are fewer than headers: a header may follow one that it includes itself, for what it finds there is what it
# would have found alone. So headers stand in chains, each below the one that includes it.
function(kanexpr_headers_alone name)
  cmake_parse_arguments(PARSE_ARGV 1 headers "" "ONLY;EXCEPT" "")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
    ${PROJECT_SOURCE_DIR}/include/*.hpp)
  if(headers_ONLY)
    list(FILTER headers INCLUDE REGEX ${headers_ONLY})
  endif()
  if(headers_EXCEPT)
    list(FILTER headers EXCLUDE REGEX ${headers_EXCEPT})
  endif()

  set(all_included)
  set(by_choice)
  foreach(header IN LISTS headers)
    file(READ ${PROJECT_SOURCE_DIR}/include/${header} text)
    # What stands below its declarations, a header does not need.
    if(NOT text MATCHES "^(//[^\n]*\n|\n)*#pragma once\n(//[^\n]*\n|#include [^\n]*\n|\n)*")
      message(FATAL_ERROR "${header} does not begin with #pragma once")
    endif()
    string(REGEX MATCHALL "#include <[^>]+>" includes "${CMAKE_MATCH_0}")
    list(TRANSFORM includes REPLACE "#include <(.*)>" "\\1")
    set(included)
    foreach(each IN LISTS includes)
      if(each IN_LIST headers)
        list(APPEND included ${each})
      endif()
    endforeach()
    set("included_by ${header}" ${included})
    list(APPEND all_included ${included})
    list(LENGTH included count)
    math(EXPR count "${count} + 100") # of as many digits as the others
    list(APPEND by_choice "${count} ${header}")
  endforeach()

  # Who has little choice chooses first, and takes what few others could take.
  list(SORT by_choice)
  set(below_others)
  foreach(header IN LISTS by_choice)
    string(SUBSTRING ${header} 4 -1 header)
    set(least)
    foreach(each IN LISTS "included_by ${header}")
      if(NOT each IN_LIST below_others)
        set(includers ${all_included})
        list(FILTER includers INCLUDE REGEX "^${each}$")
        list(LENGTH includers count)
        if(NOT least OR count LESS least)
          set(least ${count})
          set("below ${header}" ${each})
        endif()
      endif()
    endforeach()
    list(APPEND below_others ${below\ ${header}})
  endforeach()

  add_library(${name} OBJECT)
  list(REMOVE_ITEM headers ${below_others})
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "\\.hpp$" ".cpp" source ${name}/${header})
    set(chain)
    while(header)
      string(PREPEND chain "#include <${header}>\n")
      set(header ${below\ ${header}})
    endwhile()
    file(CONFIGURE OUTPUT ${source} CONTENT "${chain}" @ONLY)
    target_sources(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${source})
  endforeach()
  kanexpr_compile_headers(${name})
endfunction()

# kanexpr_headers_together(<name>): one file includes the headers at the top, which include all the others.
function(kanexpr_headers_together name)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/include/kanexpr/*.hpp)
  list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
  list(JOIN headers "" content)
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "${content}" @ONLY)
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  kanexpr_compile_headers(${name})
endfunction()

function(kanexpr_compile_headers name)
  target_link_libraries(${name} PRIVATE kanexpr kanexpr_simulate kanexpr_animate kanexpr_robots_sdf kanexpr_strict)
  target_compile_options(${name} PRIVATE -O0)
endfunction()
