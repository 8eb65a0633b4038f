# kanexpr_add_model(<target> HEADER <model.hpp> SYSTEMS <system>...): a static library with the compiled functions of
# the systems that the header defines; the names of the systems must be fully qualified, as in
# pendulum::System. Programs that link it include <target>.hpp, which contains the types and names of the model and the
# sizes of its vectors; they do not derive the model:
#
#     kanexpr_add_model(pendulum HEADER models/pendulum.hpp SYSTEMS pendulum::System)
#     target_link_libraries(program PRIVATE pendulum)           # #include <pendulum.hpp>
#
# A small program that is compiled with the model determines the sizes. When cross-compiling,
# CMAKE_CROSSCOMPILING_EMULATOR runs it.
function(kanexpr_add_model target)
  cmake_parse_arguments(PARSE_ARGV 1 model "" "HEADER" "SYSTEMS")
  if(NOT model_HEADER OR NOT model_SYSTEMS OR model_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "kanexpr_add_model(<target> HEADER <model.hpp> SYSTEMS <system>...)")
  endif()
  cmake_path(ABSOLUTE_PATH model_HEADER BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(NOT EXISTS ${model_HEADER})
    message(FATAL_ERROR "kanexpr_add_model: ${model_HEADER} does not exist")
  endif()
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/${target}_model)
  set(header ${directory}/include/${target}.hpp)

  set(added "")
  set(instantiated "")
  foreach(system IN LISTS model_SYSTEMS)
    string(APPEND added "  header.add<${system}>(\"${system}\"); "
      "// one of the SYSTEMS of kanexpr_add_model(${target} ...) in ${CMAKE_CURRENT_LIST_FILE}\n")
    string(APPEND instantiated "template class kanexpr::compiled::library_of<${system}>;\n")
  endforeach()

  file(CONFIGURE OUTPUT ${directory}/write_header.cpp @ONLY CONTENT [[
#include <kanexpr/kanexpr.hpp>

#include <kanexpr/compiled/write_model_header.hpp>

#include "@model_HEADER@"

int main(int, char** arguments) {
  kanexpr::compiled::model_header header(arguments[1], "@model_HEADER@");
@added@  return header.close() ? 0 : 1;
}
]])
  add_executable(${target}_header ${directory}/write_header.cpp)
  target_link_libraries(${target}_header PRIVATE kanexpr::kanexpr)
  file(MAKE_DIRECTORY ${directory}/include)
  add_custom_command(OUTPUT ${header} COMMAND ${target}_header ${header} DEPENDS ${target}_header
    COMMENT "Writing the sizes and names of ${target}" VERBATIM)

  file(CONFIGURE OUTPUT ${directory}/${target}.cpp @ONLY CONTENT [[
#include <@target@.hpp>

#include <kanexpr/compiled/link_model.hpp>

@instantiated@]])
  add_library(${target} STATIC ${directory}/${target}.cpp ${header})
  target_include_directories(${target} PUBLIC ${directory}/include)
  target_link_libraries(${target} PUBLIC kanexpr::kanexpr)
endfunction()
