# kanexpr_add_harness(<name> <engine>): the library that all tests link. `engine` is kanexpr if every test compiles the engine.
#
# If only some tests include a header, its implementation is a separate library, which is built if a test includes the header.
function(kanexpr_add_harness name engine)
  add_library(${name} STATIC EXCLUDE_FROM_ALL no_heap.cpp)
  target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/examples)
  # The results of two compilers are compared to the last bit, so neither may fuse a product and a sum.
  target_compile_options(${name} PUBLIC -ffp-contract=off)
  target_link_libraries(${name} PUBLIC ${engine} kanexpr_strict GTest::gmock GTest::gtest_main)
  # Eigen calls malloc directly, so replacing operator new would not detect its allocations.
  target_link_options(${name} INTERFACE
    LINKER:--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=aligned_alloc,--wrap=posix_memalign
    LINKER:--undefined=__wrap_malloc) # from the harness, before a library needs it

  foreach(header IN LISTS kanexpr_harness_headers)
    set(sources ${header}.cpp)
    if(header STREQUAL "systems/hand_written")
      list(APPEND sources systems/newton_euler.cpp)
    endif()
    cmake_path(GET header FILENAME part)
    add_library(${name}_${part} STATIC EXCLUDE_FROM_ALL ${sources})
    target_link_libraries(${name}_${part} PUBLIC ${name})
    kanexpr_link_harness(${name}_${part} ${name} ${header}.cpp)
  endforeach()
  target_compile_definitions(${name}_oracles PRIVATE KANEXPR_ORACLES="${CMAKE_CURRENT_SOURCE_DIR}/oracles")
  target_link_libraries(${name}_oracles PRIVATE nlohmann_json::nlohmann_json)
endfunction()
set(kanexpr_harness_headers oracles systems/hand_written systems/interpreted systems/linearized systems/robot_results)

# kanexpr_link_harness(<target> <harness> <file>): links the libraries of the headers that a file includes, directly
# or through other headers of the tests.
function(kanexpr_link_harness target harness file)
  set(includes ${file})
  set(left ${file})
  while(left)
    list(POP_BACK left each)
    cmake_path(GET each PARENT_PATH folder)
    file(STRINGS ${each} lines REGEX "^#include \"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" header ${line})
      cmake_path(APPEND folder ${header} OUTPUT_VARIABLE beside)
      foreach(found IN ITEMS ${header} ${beside})
        if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${found} AND NOT found IN_LIST includes)
          list(APPEND includes ${found})
          list(APPEND left ${found})
        endif()
      endforeach()
    endforeach()
  endwhile()
  foreach(header IN LISTS kanexpr_harness_headers)
    cmake_path(GET header FILENAME part)
    if("${header}.hpp" IN_LIST includes AND NOT target STREQUAL "${harness}_${part}")
      target_link_libraries(${target} PUBLIC ${harness}_${part})
    endif()
  endforeach()
endfunction()

# kanexpr_precompile(<harness>): compiles the most common headers once for the tests that link the harness.
function(kanexpr_precompile harness)
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")
  add_library(${harness}_headers OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${harness}_headers PRIVATE ${harness})
  target_precompile_headers(${harness}_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <kanexpr/symbolic.hpp>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # clang++ reads these about as fast as it reads them precompiled
    target_precompile_headers(${harness}_headers PRIVATE <kanexpr/kanexpr.hpp> <kanexpr/runtime/builder.hpp>
      <kanexpr/runtime/model.hpp>)
  endif()
  foreach(header IN LISTS kanexpr_harness_headers)
    cmake_path(GET header FILENAME part)
    target_precompile_headers(${harness}_${part} REUSE_FROM ${harness}_headers)
  endforeach()
endfunction()

# A room is a folder of the tests: the target room_<folder> builds the programs of the tests named <folder>_...
function(kanexpr_of_room room)
  if(NOT TARGET room_${room})
    add_custom_target(room_${room})
  endif()
  if(ARGN)
    add_dependencies(room_${room} ${ARGN})
  endif()
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
  foreach(source IN LISTS test_SOURCES)
    kanexpr_link_harness(${name} ${harness} ${source})
  endforeach()
  target_precompile_headers(${name} REUSE_FROM ${harness}_headers)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${test_LABELS}")
  string(REGEX REPLACE "_.*" "" room ${name})
  kanexpr_of_room(${room} ${name})
endfunction()

# A comment in a test specifies in which special builds it is included (`// builds: sanitize no-exceptions`), whether
# only one compiler builds it (`// builds: g++`), and whether only `./dev test all` runs it (`// builds: all`).
function(kanexpr_test_builds file result)
  file(STRINGS ${file} builds REGEX "^// builds: " LIMIT_COUNT 1)
  string(REPLACE "// builds: " "" builds "${builds}")
  separate_arguments(builds)
  set(${result} ${builds} PARENT_SCOPE)
endfunction()

# kanexpr_headers_alone(<name> [ONLY <regex>] [EXCEPT <regex>]): compiles every public header as the first one of a file.
#
# There are fewer files than headers: a header may follow another one that it includes anyway, because it then finds the
# same declarations. Therefore, headers form chains, in which each header comes before the one that includes it.
function(kanexpr_headers_alone name)
  cmake_parse_arguments(PARSE_ARGV 1 headers "" "ONLY;EXCEPT" "")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
    ${PROJECT_SOURCE_DIR}/include/*.hpp)
  list(FILTER headers EXCLUDE REGEX "/letters_(aside|back)\\.hpp$") # only included inside other headers, around their declarations
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
    # Includes below the declarations of a header are not needed by them.
    if(NOT text MATCHES "^(//[^\n]*\n|\n)*#pragma once\n(//[^\n]*\n|#include [^\n]*\n|\n)*")
      message(FATAL_ERROR "${header} must begin with #pragma once")
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
    math(EXPR count "${count} + 100") # so that all numbers have three digits
    list(APPEND by_choice "${count} ${header}")
  endforeach()

  # Headers with few candidates choose first, and each chooses the candidate that the fewest others could choose.
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

# kanexpr_headers_together(<name>): one file includes the top-level headers, which include all the others.
function(kanexpr_headers_together name)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/include/kanexpr/*.hpp)
  list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
  list(JOIN headers "" content)
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "${content}" @ONLY)
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  kanexpr_compile_headers(${name})
endfunction()

function(kanexpr_compile_headers name)
  target_link_libraries(${name} PRIVATE kanexpr kanexpr_hdf5 kanexpr_mpi kanexpr_animate kanexpr_fmi kanexpr_robots_sdf
    kanexpr_flexible_modes kanexpr_strict)
  target_include_directories(${name} SYSTEM PRIVATE ${PROJECT_SOURCE_DIR}/tests/quantities/mp_units)
  target_compile_options(${name} PRIVATE -O0)
endfunction()
