# cmake -P refused.cmake: kanexpr_export reports invalid arguments in one sentence, before anything is compiled.
cmake_minimum_required(VERSION 3.25)
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
set(pendulum HEADER ${root}/examples/models/simple_pendulum.hpp SYSTEM simple_pendulum::System OUTPUT exported)
set(wrong 0)

function(refuses sentence name)
  string(JOIN " " arguments ${ARGN})
  set(script ${CMAKE_CURRENT_BINARY_DIR}/refused_export.cmake)
  file(WRITE ${script} "cmake_minimum_required(VERSION 3.25)\ninclude(${root}/cmake/kanexpr_export.cmake)\n"
    "set(kanexpr_fmi_lacks \"libzip was not found\")\n"
    "kanexpr_export(${name} ${arguments})\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -P ${script} ERROR_VARIABLE told RESULT_VARIABLE status)
  file(REMOVE ${script})
  string(REGEX REPLACE "[ \n]+" " " told "${told}") # CMake breaks lines
  string(FIND "${told}" "${sentence}" place)
  if(status EQUAL 0 OR place EQUAL -1)
    message("kanexpr_export(${name} ${arguments})\n  says: ${told}\n  not: ${sentence}")
    set(wrong 1 PARENT_SCOPE)
  endif()
endfunction()

refuses("kanexpr_export(<name> HEADER <model.hpp> SYSTEM <system> FORMATS" arm FORMATS c)
refuses("kanexpr_export: /nowhere.hpp does not exist" arm HEADER /nowhere.hpp SYSTEM arm::System FORMATS c OUTPUT exported)
refuses("kanexpr_export: unknown format fortran; expected c, casadi or fmi" arm ${pendulum} FORMATS fortran)
refuses("kanexpr_export: SCALAR, WITH_PYTHON and WITH_CPP require the format c" arm ${pendulum} FORMATS fmi WITH_CPP)
refuses("kanexpr_export: RESULTS and EXPRESSIONS require the format c or fmi" arm ${pendulum} FORMATS casadi RESULTS udot)
refuses("kanexpr_export: START and STEP require the format fmi" arm ${pendulum} FORMATS c START q=1)
refuses("kanexpr_export: Python would load the library arm.so of the format casadi as the module arm" arm ${pendulum}
  FORMATS c casadi WITH_PYTHON)
refuses("kanexpr_export: runge_kutta_4 is a step and cannot be an output of the format fmi" arm ${pendulum} FORMATS c fmi
  RESULTS udot runge_kutta_4)
refuses("kanexpr_export: STEP must be greater than 0, got -1" arm ${pendulum} FORMATS fmi STEP -1)
refuses("kanexpr_export: the name of a CasADi function must begin with a letter and must not contain double underscores" my__arm
  ${pendulum} FORMATS casadi)
refuses("kanexpr_export: SCALAR must be double or float, got half" arm ${pendulum} FORMATS c SCALAR half)
refuses("kanexpr_export: BIND g is not of the form <symbol>=<number>" arm ${pendulum} FORMATS c BIND g)
refuses("kanexpr_export: there is no result U!" arm ${pendulum} FORMATS c RESULTS U!)
refuses("kanexpr_export: EXPRESSIONS tip is not of the form <name>=<expression>" arm ${pendulum} FORMATS c EXPRESSIONS tip)
refuses("kanexpr_export: the format fmi requires kanexpr::fmi: libzip was not found" arm ${pendulum} FORMATS c fmi)
if(wrong)
  message(FATAL_ERROR "kanexpr_export accepts invalid arguments, or reports a different sentence")
endif()
