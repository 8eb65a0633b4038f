# kanexpr_export(<name> HEADER <model.hpp> SYSTEM <system> FORMATS c|casadi... OUTPUT <folder> [SCALAR double|float] [WITH_PYTHON]
#   [WITH_CPP] [BIND <parameter>=<number>...] [RESULTS <results>...] [EXPRESSIONS <name>=<expression>...]): the target <name>
# leaves results of a system in a folder, for other languages: of the format c <name>.c and <name>.h, with Python <name>.py
# and with C++ <name>.hpp too; of casadi the rates of the state and their derivatives, <name>_casadi.c and .h, and compiled
# <name>.so. Of C each of RESULTS is a function, of one result or of several with spaces between them, or one of the steps
# runge_kutta_4 and semi_implicit_euler; each of EXPRESSIONS is one of the model, in its words. Without either there are M
# and f, u̇, ẋ, and A and B:
#
#     kanexpr_export(pendulum HEADER models/pendulum.hpp SYSTEM pendulum::System FORMATS c OUTPUT exported
#       SCALAR float BIND g=9.81 RESULTS udot "mass_matrix forcing" EXPRESSIONS "tip=position_of<P, O>")
#
# A program that is compiled here writes them. Where one compiles for another machine, CMAKE_CROSSCOMPILING_EMULATOR runs
# it.
function(kanexpr_export name)
  cmake_parse_arguments(PARSE_ARGV 1 export "WITH_PYTHON;WITH_CPP" "HEADER;SYSTEM;OUTPUT;SCALAR" "FORMATS;BIND;RESULTS;EXPRESSIONS")
  if(NOT export_HEADER OR NOT export_SYSTEM OR NOT export_FORMATS OR NOT export_OUTPUT OR export_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "kanexpr_export(<name> HEADER <model.hpp> SYSTEM <system> FORMATS c|casadi... OUTPUT <folder> "
      "[SCALAR double|float] [WITH_PYTHON] [WITH_CPP] [BIND <parameter>=<number>...] [RESULTS <results>...] "
      "[EXPRESSIONS <name>=<expression>...])")
  endif()
  cmake_path(ABSOLUTE_PATH export_HEADER BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  cmake_path(ABSOLUTE_PATH export_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  if(NOT EXISTS ${export_HEADER})
    message(FATAL_ERROR "kanexpr_export: there is no ${export_HEADER}")
  endif()
  foreach(format IN LISTS export_FORMATS)
    if(NOT format MATCHES "^(c|casadi)$")
      message(FATAL_ERROR "kanexpr_export: there is no format ${format}; there are c and casadi")
    endif()
  endforeach()
  if(NOT "c" IN_LIST export_FORMATS AND (export_SCALAR OR export_RESULTS OR export_EXPRESSIONS OR export_WITH_PYTHON OR export_WITH_CPP))
    message(FATAL_ERROR "kanexpr_export: SCALAR, RESULTS, EXPRESSIONS, WITH_PYTHON and WITH_CPP are of the format c")
  endif()

  set(chosen "")
  if(export_SCALAR STREQUAL "float")
    string(APPEND chosen "  chosen.number = kanexpr::exporting::precision::single_precision;\n")
  elseif(export_SCALAR AND NOT export_SCALAR STREQUAL "double")
    message(FATAL_ERROR "kanexpr_export: SCALAR is double or float, not ${export_SCALAR}")
  endif()
  set(files "")
  set(writes "")
  if("c" IN_LIST export_FORMATS)
    list(APPEND files ${export_OUTPUT}/${name}.c ${export_OUTPUT}/${name}.h)
    string(APPEND writes "  written = kanexpr::write_c<${export_SYSTEM}>(arguments[1], \"${name}\", chosen);\n")
  endif()
  if("casadi" IN_LIST export_FORMATS)
    list(APPEND files ${export_OUTPUT}/${name}_casadi.c ${export_OUTPUT}/${name}_casadi.h)
    string(APPEND writes "  if (written)\n    written = kanexpr::write_casadi<${export_SYSTEM}>(arguments[1], "
      "\"${name}\", {chosen.bound});\n")
  endif()
  if(export_WITH_PYTHON)
    string(APPEND chosen "  chosen.with_python = true;\n")
    list(APPEND files ${export_OUTPUT}/${name}.py)
  endif()
  if(export_WITH_CPP)
    string(APPEND chosen "  chosen.with_cpp = true;\n")
    list(APPEND files ${export_OUTPUT}/${name}.hpp)
  endif()
  foreach(bound IN LISTS export_BIND)
    if(NOT bound MATCHES "^([^=\"\\\\]+)=([-+]?[0-9]+(\\.[0-9]*)?([eE][-+]?[0-9]+)?)$")
      message(FATAL_ERROR "kanexpr_export: BIND ${bound} is not <parameter>=<number>")
    endif()
    set(bound_name ${CMAKE_MATCH_1})
    set(bound_number ${CMAKE_MATCH_2})
    if(bound_number MATCHES "^[-+]?[0-9]+$")
      string(APPEND bound_number ".0") # no int of C++, nor an octal one
    endif()
    string(APPEND chosen "  chosen.bound.push_back({\"${bound_name}\", ${bound_number}});\n")
  endforeach()
  if(export_RESULTS OR export_EXPRESSIONS)
    string(APPEND chosen "  chosen.functions.clear();\n")
  endif()
  foreach(results IN LISTS export_RESULTS)
    if(NOT results MATCHES "^[a-z0-9_ ]+$")
      message(FATAL_ERROR "kanexpr_export: no result is called ${results}")
    endif()
    string(APPEND chosen "  chosen.functions.push_back(kanexpr::exporting::results(\"${results}\"));\n")
  endforeach()

  set(words "")
  foreach(each IN LISTS export_EXPRESSIONS)
    if(NOT each MATCHES "^([A-Za-z_][A-Za-z0-9_]*)=(.+)$")
      message(FATAL_ERROR "kanexpr_export: EXPRESSIONS ${each} is not <name>=<expression>")
    endif()
    string(APPEND chosen
      "  chosen.functions.push_back(kanexpr::exporting::expression<(${CMAKE_MATCH_2})>(\"${CMAKE_MATCH_1}\"));\n")
    if(export_SYSTEM MATCHES "^(.+)::[^:]+$")
      set(words "  using namespace ${CMAKE_MATCH_1};\n")
    endif()
  endforeach()

  set(directory ${CMAKE_CURRENT_BINARY_DIR}/${name}_exported)
  file(CONFIGURE OUTPUT ${directory}/write.cpp @ONLY CONTENT [[
#include <kanexpr/export.hpp>

#include "@export_HEADER@"

#include <cstdio>

int main(int, char** arguments) {
@words@  kanexpr::exporting::c_options chosen;
@chosen@  kanexpr::outcome written;
@writes@  if (!written) std::fprintf(stderr, "kanexpr_export(@name@ ...): %s\n", written.cause().c_str());
  return written ? 0 : 1;
}
]])
  add_executable(${name}_export ${directory}/write.cpp)
  if(TARGET kanexpr::engine AND (KANEXPR_BUILD_ENGINE OR NOT DEFINED KANEXPR_BUILD_ENGINE))
    target_link_libraries(${name}_export PRIVATE kanexpr::engine)
  else()
    target_link_libraries(${name}_export PRIVATE kanexpr::kanexpr)
  endif()
  add_custom_command(OUTPUT ${files} COMMAND ${name}_export ${export_OUTPUT} DEPENDS ${name}_export
    COMMENT "Writing ${name} in C" VERBATIM)
  if("casadi" IN_LIST export_FORMATS)
    find_program(KANEXPR_C_COMPILER NAMES cc gcc clang clang-19 REQUIRED)
    add_custom_command(OUTPUT ${export_OUTPUT}/${name}.so
      COMMAND ${KANEXPR_C_COMPILER} -std=c99 -O2 -fno-math-errno -ffp-contract=fast -shared -fPIC
        ${export_OUTPUT}/${name}_casadi.c -o ${export_OUTPUT}/${name}.so -lm
      DEPENDS ${export_OUTPUT}/${name}_casadi.c ${export_OUTPUT}/${name}_casadi.h
      COMMENT "Compiling ${name}.so for CasADi" VERBATIM)
    list(APPEND files ${export_OUTPUT}/${name}.so)
  endif()
  add_custom_target(${name} ALL DEPENDS ${files})
endfunction()
