# kanexpr_export(<name> HEADER <model.hpp> SYSTEM <system> FORMATS c|casadi|fmi... OUTPUT <folder> [SCALAR double|float] [WITH_PYTHON]
#   [WITH_CPP] [BIND <parameter>=<number>...] [START <symbol>=<number>...] [STEP <number>]
#   [STEP_METHOD <name>] [RESULTS <results>...] [EXPRESSIONS <name>=<expression>...]): the target
# <name> writes results of a system for other languages to a folder. The format c writes <name>.c and <name>.h, and optionally
# <name>.py for Python and <name>.hpp for C++; casadi writes the rates of the state and a step by STEP_METHOD with their derivatives,
# <name>_casadi.c and .h, and the compiled <name>.so; fmi writes <name>.fmu, with the initial values START and, for co-simulation, the
# step STEP by STEP_METHOD, and requires kanexpr::fmi. In C, each of RESULTS is a function of one or several results, separated by spaces,
# or one of the steps runge_kutta_4, ralston_3 and semi_implicit_euler; each of EXPRESSIONS is an expression in the words of the model. If
# both are omitted, M and f, u̇, ẋ, and A and B are exported. In an FMU they are outputs in addition to the state:
#
#     kanexpr_export(pendulum HEADER models/pendulum.hpp SYSTEM pendulum::System FORMATS c OUTPUT exported
#       SCALAR float BIND g=9.81 RESULTS udot "mass_matrix forcing" EXPRESSIONS "tip=position_of<P, O>")
#
# A program that is compiled here writes the files. When cross-compiling, CMAKE_CROSSCOMPILING_EMULATOR runs it.
function(kanexpr_export name)
  cmake_parse_arguments(PARSE_ARGV 1 export "WITH_PYTHON;WITH_CPP" "HEADER;SYSTEM;OUTPUT;SCALAR;STEP;STEP_METHOD"
    "FORMATS;BIND;START;RESULTS;EXPRESSIONS")
  if(NOT export_HEADER OR NOT export_SYSTEM OR NOT export_FORMATS OR NOT export_OUTPUT OR export_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "kanexpr_export(<name> HEADER <model.hpp> SYSTEM <system> FORMATS c|casadi|fmi... OUTPUT <folder> "
      "[SCALAR double|float] [WITH_PYTHON] [WITH_CPP] [BIND <parameter>=<number>...] [START <symbol>=<number>...] "
      "[STEP <number>] [STEP_METHOD <name>] [RESULTS <results>...] "
      "[EXPRESSIONS <name>=<expression>...])")
  endif()
  cmake_path(ABSOLUTE_PATH export_HEADER BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  cmake_path(ABSOLUTE_PATH export_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  if(NOT EXISTS ${export_HEADER})
    message(FATAL_ERROR "kanexpr_export: ${export_HEADER} does not exist")
  endif()
  foreach(format IN LISTS export_FORMATS)
    if(NOT format MATCHES "^(c|casadi|fmi)$")
      message(FATAL_ERROR "kanexpr_export: unknown format ${format}; expected c, casadi or fmi")
    endif()
  endforeach()
  if(NOT "c" IN_LIST export_FORMATS AND (export_SCALAR OR export_WITH_PYTHON OR export_WITH_CPP))
    message(FATAL_ERROR "kanexpr_export: SCALAR, WITH_PYTHON and WITH_CPP require the format c")
  endif()
  if(NOT "c" IN_LIST export_FORMATS AND NOT "fmi" IN_LIST export_FORMATS AND (export_RESULTS OR export_EXPRESSIONS))
    message(FATAL_ERROR "kanexpr_export: RESULTS and EXPRESSIONS require the format c or fmi")
  endif()
  if(NOT "fmi" IN_LIST export_FORMATS AND (export_START OR export_STEP))
    message(FATAL_ERROR "kanexpr_export: START and STEP require the format fmi")
  endif()
  if(export_STEP_METHOD AND NOT "casadi" IN_LIST export_FORMATS AND NOT "fmi" IN_LIST export_FORMATS)
    message(FATAL_ERROR "kanexpr_export: STEP_METHOD requires the format casadi or fmi")
  endif()
  if(NOT export_STEP_METHOD)
    set(export_STEP_METHOD runge_kutta_4)
  endif()

  if("casadi" IN_LIST export_FORMATS AND export_WITH_PYTHON)
    message(FATAL_ERROR "kanexpr_export: Python would load the library ${name}.so of the format casadi as the module ${name}; "
      "use a separate call of kanexpr_export with a different name or OUTPUT")
  endif()
  if("fmi" IN_LIST export_FORMATS AND "${export_RESULTS}" MATCHES "runge_kutta_4|semi_implicit_euler")
    message(FATAL_ERROR "kanexpr_export: ${CMAKE_MATCH_0} is a step and cannot be an output of the format fmi; export it with a separate call of kanexpr_export")
  endif()
  if("fmi" IN_LIST export_FORMATS AND DEFINED export_STEP AND NOT export_STEP GREATER 0)
    message(FATAL_ERROR "kanexpr_export: STEP must be greater than 0, got ${export_STEP}")
  endif()
  if("casadi" IN_LIST export_FORMATS AND NOT name MATCHES "^[A-Za-z](_?[A-Za-z0-9]+)*$")
    message(FATAL_ERROR "kanexpr_export: the name of a CasADi function must begin with a letter and must not contain double underscores or "
      "end with an underscore, got ${name}")
  endif()

  set(chosen "")
  if(export_SCALAR STREQUAL "float")
    string(APPEND chosen "  chosen.number = kanexpr::exporting::precision::single_precision;\n")
  elseif(export_SCALAR AND NOT export_SCALAR STREQUAL "double")
    message(FATAL_ERROR "kanexpr_export: SCALAR must be double or float, got ${export_SCALAR}")
  endif()
  set(files "")
  set(writes "")
  if("c" IN_LIST export_FORMATS)
    list(APPEND files ${export_OUTPUT}/${name}.c ${export_OUTPUT}/${name}.h)
    string(APPEND writes "  written = kanexpr::write_c<${export_SYSTEM}>(arguments[1], \"${name}\", chosen);\n")
  endif()
  set(of_fmu "")
  set(header_for_fmi "")
  if("fmi" IN_LIST export_FORMATS OR "casadi" IN_LIST export_FORMATS)
    find_program(KANEXPR_C_COMPILER NAMES cc gcc clang clang-19 REQUIRED)
  endif()
  if("fmi" IN_LIST export_FORMATS)
    list(APPEND files ${export_OUTPUT}/${name}.fmu)
    set(header_for_fmi "#include <kanexpr/fmi.hpp>\n")
    set(of_fmu "  fmu.compiler = \"'${KANEXPR_C_COMPILER}'\";\n  fmu.method = \"${export_STEP_METHOD}\";\n")
    if(export_STEP)
      kanexpr_export_numbers(STEP "  fmu.step = @number@;\n" "s=${export_STEP}" of_fmu)
    endif()
    string(APPEND writes "  if (written) {\n    const kanexpr::exporting::written_fmu made = kanexpr::write_fmu<${export_SYSTEM}>("
      "arguments[1], \"${name}\", fmu);\n"
      "    if (!made.note().empty()) std::fprintf(stderr, \"%s\\n\", made.note().c_str());\n    written = made;\n  }\n")
  endif()
  if("casadi" IN_LIST export_FORMATS)
    list(APPEND files ${export_OUTPUT}/${name}_casadi.c ${export_OUTPUT}/${name}_casadi.h)
    string(APPEND writes "  if (written)\n    written = kanexpr::write_casadi<${export_SYSTEM}>(arguments[1], "
      "\"${name}\",\n      {chosen.bound, \"${export_STEP_METHOD}\"});\n")
  endif()
  if(export_WITH_PYTHON)
    string(APPEND chosen "  chosen.with_python = true;\n")
    list(APPEND files ${export_OUTPUT}/${name}.py)
  endif()
  if(export_WITH_CPP)
    string(APPEND chosen "  chosen.with_cpp = true;\n")
    list(APPEND files ${export_OUTPUT}/${name}.hpp)
  endif()
  kanexpr_export_numbers(BIND "  chosen.bound.push_back({\"@symbol@\", @number@});\n" "${export_BIND}" chosen)
  kanexpr_export_numbers(START "  fmu.start.push_back({\"@symbol@\", @number@});\n" "${export_START}" of_fmu)
  if(export_RESULTS OR export_EXPRESSIONS)
    string(APPEND chosen "  chosen.functions.clear();\n")
  endif()
  foreach(results IN LISTS export_RESULTS)
    if(NOT results MATCHES "^[a-z0-9_ ]+$")
      message(FATAL_ERROR "kanexpr_export: there is no result ${results}")
    endif()
    string(APPEND chosen "  chosen.functions.push_back(kanexpr::exporting::results(\"${results}\"));\n")
  endforeach()

  set(words "")
  foreach(each IN LISTS export_EXPRESSIONS)
    if(NOT each MATCHES "^([A-Za-z_][A-Za-z0-9_]*)=(.+)$")
      message(FATAL_ERROR "kanexpr_export: EXPRESSIONS ${each} is not of the form <name>=<expression>")
    endif()
    string(APPEND chosen
      "  chosen.functions.push_back(kanexpr::exporting::expression<(${CMAKE_MATCH_2})>(\"${CMAKE_MATCH_1}\"));\n")
    if(export_SYSTEM MATCHES "^([^<]+)::[^:<]+(<.*)?$")
      set(words "  using namespace ${CMAKE_MATCH_1};\n")
    endif()
  endforeach()

  if("fmi" IN_LIST export_FORMATS)
    if(export_RESULTS OR export_EXPRESSIONS)
      string(PREPEND of_fmu "  fmu.outputs = chosen.functions;\n")
    endif()
    string(PREPEND of_fmu "  kanexpr::exporting::fmu_options fmu;\n  fmu.bound = chosen.bound;\n")
  endif()

  if("fmi" IN_LIST export_FORMATS AND NOT TARGET kanexpr::fmi)
    message(FATAL_ERROR "kanexpr_export: the format fmi requires kanexpr::fmi: ${kanexpr_fmi_lacks}")
  endif()

  set(directory ${CMAKE_CURRENT_BINARY_DIR}/${name}_exported)
  file(CONFIGURE OUTPUT ${directory}/write.cpp @ONLY CONTENT [[
#include <kanexpr/export.hpp>
@header_for_fmi@
#include "@export_HEADER@"

#include <cstdio>

int main(int, char** arguments) {
@words@  kanexpr::exporting::c_options chosen;
@chosen@@of_fmu@  kanexpr::outcome written;
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
  if("fmi" IN_LIST export_FORMATS)
    target_link_libraries(${name}_export PRIVATE kanexpr::fmi)
  endif()
  target_compile_options(${name}_export PRIVATE -O0) # it runs once
  add_custom_command(OUTPUT ${files} COMMAND ${name}_export ${export_OUTPUT} DEPENDS ${name}_export
    COMMENT "Writing ${name}" VERBATIM)
  if("casadi" IN_LIST export_FORMATS)
    add_custom_command(OUTPUT ${export_OUTPUT}/${name}.so
      COMMAND ${KANEXPR_C_COMPILER} -std=c99 -O2 -fno-math-errno -ffp-contract=fast -shared -fPIC
        ${export_OUTPUT}/${name}_casadi.c -o ${export_OUTPUT}/${name}.so -lm
      DEPENDS ${export_OUTPUT}/${name}_casadi.c ${export_OUTPUT}/${name}_casadi.h
      COMMENT "Compiling ${name}.so for CasADi" VERBATIM)
    list(APPEND files ${export_OUTPUT}/${name}.so)
  endif()
  add_custom_target(${name} ALL DEPENDS ${files})
endfunction()

# Appends code to the variable `to` for each <symbol>=<number> of an option.
function(kanexpr_export_numbers option code assignments to)
  set(all "${${to}}")
  foreach(each IN LISTS assignments)
    if(NOT each MATCHES "^([^=\"\\\\]+)=([-+]?[0-9]+(\\.[0-9]*)?([eE][-+]?[0-9]+)?)$")
      message(FATAL_ERROR "kanexpr_export: ${option} ${each} is not of the form <symbol>=<number>")
    endif()
    set(symbol ${CMAKE_MATCH_1})
    set(number ${CMAKE_MATCH_2})
    if(number MATCHES "^[-+]?[0-9]+$")
      string(APPEND number ".0") # not a C++ int, which may be octal
    endif()
    string(CONFIGURE "${code}" line @ONLY)
    string(APPEND all "${line}")
  endforeach()
  set(${to} "${all}" PARENT_SCOPE)
endfunction()
