# kanexpr_test(<name> SOURCES <file>...): one GoogleTest program, registered as one test.
function(kanexpr_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "" "SOURCES;LABELS")
  add_executable(${name} ${test_SOURCES})
  target_link_libraries(${name} PRIVATE kanexpr_harness)
  if(TARGET kanexpr_precompiled)
    target_precompile_headers(${name} REUSE_FROM kanexpr_precompiled)
  endif()
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

# Compiles every public header alone, and twice in one file.
function(kanexpr_headers_alone name)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
    ${PROJECT_SOURCE_DIR}/include/*.hpp)
  add_library(${name} OBJECT)
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "\\.hpp$" ".cpp" source ${name}/${header})
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
    target_sources(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${source})
  endforeach()
  target_link_libraries(${name} PRIVATE kanexpr kanexpr_strict)
  target_compile_options(${name} PRIVATE -O0)
endfunction()
