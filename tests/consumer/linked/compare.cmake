# compare.cmake -DDIRECTORY=<of the programs>: both must print the same.
foreach(program linked whole)
  execute_process(COMMAND ${DIRECTORY}/${program} OUTPUT_VARIABLE ${program} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT linked STREQUAL whole OR NOT linked MATCHES "cannot be solved")
  message(FATAL_ERROR "the functions of a linked model give\n${linked}in place of\n${whole}")
endif()

execute_process(COMMAND ${CMAKE_COMMAND} --build . --target aligned RESULT_VARIABLE refused OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT refused OR NOT said MATCHES "undefined")
  message(FATAL_ERROR "a program whose vectors are aligned differently links the model\n${said}")
endif()
