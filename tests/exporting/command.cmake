# kanexpr-export writes the same bytes as write_c, for models and for robots.
set(by_command ${CMAKE_CURRENT_BINARY_DIR}/by_command)
add_test(NAME exporting_command_of_robot COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/exporting/command $<TARGET_FILE:kanexpr-export>
  ${CMAKE_CURRENT_SOURCE_DIR}/robots/files/arm.urdf ${by_command}_of_robot)
kanexpr_of_room(exporting kanexpr-export)
set(by_function)
if(TARGET exporting_models_in_c)
  set(by_function ${CMAKE_CURRENT_BINARY_DIR}/written/bound_pendulum)
endif()
add_test(NAME exporting_guide COMMAND ${CMAKE_COMMAND} -E env CXX=${CMAKE_CXX_COMPILER} ${CMAKE_CURRENT_SOURCE_DIR}/exporting/guide
  $<TARGET_FILE:kanexpr-export> ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/docs/snippets/docs/export/c
  ${by_command}_of_guide ${by_function})
