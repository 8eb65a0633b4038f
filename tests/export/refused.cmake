# cmake -P refused.cmake: kanexpr_export says in one sentence what it does not take, before anything is compiled.
cmake_minimum_required(VERSION 3.25)
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
set(pendulum HEADER ${root}/examples/models/simple_pendulum.hpp SYSTEM simple_pendulum::System OUTPUT exported)
set(wrong 0)

function(refuses sentence name)
  string(JOIN " " arguments ${ARGN})
  set(script ${CMAKE_CURRENT_BINARY_DIR}/refused_export.cmake)
  file(WRITE ${script} "cmake_minimum_required(VERSION 3.25)\ninclude(${root}/cmake/kanexpr_export.cmake)\n"
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
refuses("kanexpr_export: there is no /nowhere.hpp" arm HEADER /nowhere.hpp SYSTEM arm::System FORMATS c OUTPUT exported)
refuses("kanexpr_export: there is no format fortran; there are c, casadi and fmi" arm ${pendulum} FORMATS fortran)
refuses("kanexpr_export: SCALAR, WITH_PYTHON and WITH_CPP are of the format c" arm ${pendulum} FORMATS fmi WITH_CPP)
refuses("kanexpr_export: RESULTS and EXPRESSIONS are of the formats c and fmi" arm ${pendulum} FORMATS casadi RESULTS udot)
refuses("kanexpr_export: START and STEP are of the format fmi" arm ${pendulum} FORMATS c START q=1)
refuses("kanexpr_export: Python would take the library arm.so of the format casadi for the module arm" arm ${pendulum}
  FORMATS c casadi WITH_PYTHON)
refuses("kanexpr_export: runge_kutta_4 is a step, and no output of the format fmi" arm ${pendulum} FORMATS c fmi
  RESULTS udot runge_kutta_4)
refuses("kanexpr_export: STEP is a length of time above 0, not -1" arm ${pendulum} FORMATS fmi STEP -1)
refuses("kanexpr_export: a function of CasADi needs a name that begins with a letter and has no two underscores in a row" my__arm
  ${pendulum} FORMATS casadi)
refuses("kanexpr_export: SCALAR is double or float, not half" arm ${pendulum} FORMATS c SCALAR half)
refuses("kanexpr_export: BIND g is not <symbol>=<number>" arm ${pendulum} FORMATS c BIND g)
refuses("kanexpr_export: no result is called U!" arm ${pendulum} FORMATS c RESULTS U!)
refuses("kanexpr_export: EXPRESSIONS tip is not <name>=<expression>" arm ${pendulum} FORMATS c EXPRESSIONS tip)
if(wrong)
  message(FATAL_ERROR "kanexpr_export takes what it should refuse, or says something else")
endif()
