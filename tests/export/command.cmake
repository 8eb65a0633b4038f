# kanexpr-export writes what write_c writes, to the byte, of models and of robots.
set(by_command ${CMAKE_CURRENT_BINARY_DIR}/by_command)
add_test(NAME export_command_of_model COMMAND ${CMAKE_COMMAND} -E env CXX=${CMAKE_CXX_COMPILER} $<TARGET_FILE:kanexpr-export>
  ${PROJECT_SOURCE_DIR}/examples/models/simple_pendulum.hpp --system simple_pendulum::System --name bound_pendulum
  --output ${by_command} --scalar float --bind g=9.81 --bind m=2 --results udot --results "mass_matrix forcing"
  --expression "tip=position_of<P, O>"
  -I ${PROJECT_SOURCE_DIR}/include -I ${PROJECT_SOURCE_DIR}/examples)
set_tests_properties(export_command_of_model PROPERTIES FIXTURES_SETUP export_command_of_model)
add_test(NAME export_command_of_robot COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/export/command $<TARGET_FILE:kanexpr-export>
  ${CMAKE_CURRENT_SOURCE_DIR}/robots/files/arm.urdf ${by_command}_of_robot)
if(TARGET export_models_in_c)
  foreach(file IN ITEMS bound_pendulum.c bound_pendulum.h)
    add_test(NAME export_command_${file}
      COMMAND ${CMAKE_COMMAND} -E compare_files ${by_command}/${file} ${CMAKE_CURRENT_BINARY_DIR}/written/${file})
    set_tests_properties(export_command_${file} PROPERTIES FIXTURES_REQUIRED export_command_of_model)
  endforeach()
endif()
