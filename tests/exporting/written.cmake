# The generated code is compiled by a C compiler, without fused operations, and linked with its tests.
find_program(KANEXPR_C_COMPILER NAMES cc gcc clang-19 REQUIRED)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/written)
add_executable(exporting_models_in_c exporting/models_in_c.cpp)
target_compile_options(exporting_models_in_c PRIVATE -O0) # it writes the files once
target_include_directories(exporting_models_in_c PRIVATE ${PROJECT_SOURCE_DIR}/examples ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(exporting_models_in_c PRIVATE kanexpr::engine kanexpr::fmi kanexpr_strict kanexpr_snippets)
set(for_casadi cart driven a wheel bound_pendulum disc motor_arm loaded_arm cornering_car elbow)
list(TRANSFORM for_casadi REPLACE "(.+)" "${folder}/\\1_casadi.c" OUTPUT_VARIABLE files_for_casadi)
set(names iiwa iiwa_in_float iiwa_columns iiwa_columns_in_float iiwa_in_pieces iiwa_in_pieces_in_float curved curved_in_float sliders sliders_in_float slewing_arm slewing_arm_in_float bouncing_ball bouncing_ball_in_float four_bar four_bar_in_float four_bar_in_pieces four_bar_in_pieces_in_float disc disc_in_float bound_pendulum pendulum motor_arm motor_arm_in_float loaded_arm loaded_arm_in_float
  cornering_car cornering_car_in_float driven_wheel driven_wheel_in_float)
set(names_of_steps sliding sliding_in_float bead bead_in_float appell_hamel appell_hamel_in_float)
set(names_of_all ${names} ${names_of_steps})
set(fmus bound_pendulum pendulum ball bead sliding strange lift four_bar appell_hamel motor_arm loaded_arm cornering_car
  driven_wheel)
list(TRANSFORM fmus REPLACE "(.+)" "${folder}/\\1.fmu")
list(TRANSFORM names_of_all REPLACE "(.+)" "${folder}/\\1.c" OUTPUT_VARIABLE files)
add_custom_command(OUTPUT ${files} ${files_for_casadi} ${fmus} COMMAND exporting_models_in_c ${folder} DEPENDS exporting_models_in_c VERBATIM)
foreach(name IN LISTS names_of_all)
  add_custom_command(OUTPUT ${folder}/${name}.o COMMAND ${KANEXPR_C_COMPILER} -std=c99 -O1 -ffp-contract=off -fPIE -pedantic
    -Wall -Wextra -Wconversion -Wshadow -Werror -c ${folder}/${name}.c -o ${folder}/${name}.o
    DEPENDS ${folder}/${name}.c VERBATIM)
  if(name IN_LIST names)
    target_sources(exporting_c PRIVATE ${folder}/${name}.o)
  else()
    target_sources(exporting_c_steps PRIVATE ${folder}/${name}.o)
  endif()
endforeach()
target_link_libraries(exporting_c PRIVATE kanexpr_snippets)
foreach(test IN ITEMS exporting_c exporting_c_steps)
  target_include_directories(${test} SYSTEM PRIVATE ${folder})
endforeach()
set_source_files_properties(exporting/c_test.cpp exporting/c_steps_test.cpp PROPERTIES OBJECT_DEPENDS "${files}")

kanexpr_of_room(exporting exporting_models_in_c bound_pendulum)

# Every compiler accepts it.
add_test(NAME exporting_c_compilers COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/exporting/compilers ${folder})

# CMake generates the same bytes.
kanexpr_export(bound_pendulum HEADER ${PROJECT_SOURCE_DIR}/examples/models/simple_pendulum.hpp SYSTEM simple_pendulum::System
  FORMATS c casadi fmi OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/by_cmake SCALAR float BIND g=9.81 m=2 START q=0.3 l=0.5 c=1e-1
  STEP 0.01 STEP_METHOD ralston_3 RESULTS udot "mass_matrix forcing" EXPRESSIONS "tip=position_of<P, O>")
target_include_directories(bound_pendulum_export PRIVATE ${PROJECT_SOURCE_DIR}/examples)
foreach(file IN ITEMS bound_pendulum.c bound_pendulum.h bound_pendulum_casadi.c bound_pendulum_casadi.h bound_pendulum.fmu)
  add_test(NAME exporting_${file} COMMAND ${CMAKE_COMMAND} -E compare_files ${CMAKE_CURRENT_BINARY_DIR}/by_cmake/${file} ${folder}/${file})
endforeach()

# Python modules, with the commands of the guide
set(guide ${CMAKE_CURRENT_BINARY_DIR}/docs/snippets/docs/export/c)
add_test(NAME exporting_python COMMAND sh -eu -c "cd '${folder}'
  for name in bead four_bar iiwa pendulum sliders; do
    sed \"s|cc |'${KANEXPR_C_COMPILER}' |; s|pendulum|$name|g\" '${guide}/compile.sh' | sh -eu
  done
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=. python3 '${guide}/session.python'
  python3 '${CMAKE_CURRENT_SOURCE_DIR}/exporting/python_test.py' '${folder}'")

add_test(NAME exporting_refused COMMAND ${CMAKE_COMMAND} -P ${CMAKE_CURRENT_SOURCE_DIR}/exporting/refused.cmake)

# Headers for C++11
add_test(NAME exporting_cpp COMMAND sh -eu -c "
  '${CMAKE_CXX_COMPILER}' -std=c++11 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -I '${folder}' -I '${CMAKE_CURRENT_BINARY_DIR}/docs/snippets' \
    '${CMAKE_CURRENT_SOURCE_DIR}/exporting/cpp.cpp' '${folder}/pendulum.o' '${folder}/four_bar.o' '${folder}/bead_in_float.o' -lm -o '${folder}/cpp'
  '${folder}/cpp'")

# Functions as CasADi calls them, with the command of the guide; optimizing the longest would take most of the time
add_test(NAME exporting_casadi COMMAND sh -eu -c "cd '${folder}'
  for name in cart driven a wheel disc motor_arm loaded_arm cornering_car elbow; do
    level=-O2
    case $name in loaded_arm | cornering_car | elbow) level=-O0 ;; esac
    sed \"s|cc |'${KANEXPR_C_COMPILER}' |; s|-O2|$level|; s|cart|$name|g\" '${CMAKE_CURRENT_BINARY_DIR}/docs/snippets/docs/export/casadi/compile.sh' |
      sh -eu
  done
  cp '${CMAKE_CURRENT_BINARY_DIR}/by_cmake/bound_pendulum.so' .
  python3 '${CMAKE_CURRENT_SOURCE_DIR}/exporting/casadi_test.py' '${folder}'")

# FMUs as a tool imports them
add_test(NAME exporting_fmi COMMAND ${CMAKE_COMMAND} -E env CC=${KANEXPR_C_COMPILER} ${CMAKE_CURRENT_SOURCE_DIR}/exporting/fmi ${folder})
