# Writes the compiler flags of a consumer of the library to a response file, for the checks
# that call the compiler directly (mistakes, compile cost).
function(kanexpr_consumer_flags file)
  file(GENERATE OUTPUT ${file} CONTENT
"-std=c++20
$<JOIN:$<TARGET_PROPERTY:kanexpr_consumer,COMPILE_OPTIONS>,\n>
-I\"$<JOIN:$<TARGET_PROPERTY:kanexpr_consumer,INCLUDE_DIRECTORIES>,\"\n-I\">\"
" TARGET kanexpr_consumer)
endfunction()

file(WRITE ${PROJECT_BINARY_DIR}/consumer.cpp "")
add_library(kanexpr_consumer OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/consumer.cpp)
target_link_libraries(kanexpr_consumer PRIVATE kanexpr)
target_include_directories(kanexpr_consumer PRIVATE ${PROJECT_SOURCE_DIR}/examples)
