# kanexpr_add_flexible_body(<target> FILE <file> [OPTIONS <option>...]): a header-only library. <target>.hpp contains the namespace
# <target> with `data`, the numbers of the flexible body that the file describes:
#
#     kanexpr_add_flexible_body(panel FILE panel.SID_FEM)
#     target_link_libraries(program PRIVATE panel)               # #include <panel.hpp>
#
# The command kanexpr-flexible-body writes the header; OPTIONS are passed to it. If kanexpr is installed, its command is used; otherwise,
# the command is compiled here, with CLI11. When cross-compiling, either CMAKE_CROSSCOMPILING_EMULATOR runs it, or
# kanexpr_FLEXIBLE_BODY_COMMAND specifies a command that runs on the host.
function(kanexpr_add_flexible_body target)
  cmake_parse_arguments(PARSE_ARGV 1 body "" "FILE" "OPTIONS")
  if(NOT body_FILE OR body_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "kanexpr_add_flexible_body(<target> FILE <file> [OPTIONS <option>...])")
  endif()
  set(file ${body_FILE})
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "kanexpr_add_flexible_body: ${file} does not exist")
  endif()
  kanexpr_find_flexible_body_command(command)
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/${target}_body)
  set(header ${directory}/${target}.hpp)
  file(MAKE_DIRECTORY ${directory})
  add_custom_command(OUTPUT ${header}
    COMMAND ${command} ${file} --name ${target} --output ${header} ${body_OPTIONS}
    DEPENDS ${file} ${command} COMMENT "Writing the numbers of ${target}" VERBATIM)
  add_custom_target(${target}_header DEPENDS ${header})
  add_library(${target} INTERFACE ${file}) # with a source, so that building the target writes the header
  add_dependencies(${target} ${target}_header)
  target_include_directories(${target} INTERFACE ${directory})
  target_link_libraries(${target} INTERFACE kanexpr::kanexpr)
endfunction()

# Sets the command that writes headers: the specified one, the installed one, or one that is compiled once for all bodies in the
# project.
function(kanexpr_find_flexible_body_command command)
  set(${command} kanexpr-flexible-body PARENT_SCOPE)
  if(kanexpr_FLEXIBLE_BODY_COMMAND)
    set(${command} ${kanexpr_FLEXIBLE_BODY_COMMAND} PARENT_SCOPE)
    return()
  elseif(TARGET kanexpr-flexible-body)
    return()
  elseif(EXISTS "${kanexpr_installed_flexible_body_command}" AND NOT CMAKE_CROSSCOMPILING)
    set(${command} ${kanexpr_installed_flexible_body_command} PARENT_SCOPE)
    return()
  endif()
  find_package(CLI11 QUIET)
  if(NOT CLI11_FOUND)
    message(FATAL_ERROR "kanexpr_add_flexible_body requires CLI11, which was not found")
  endif()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/kanexpr_flexible_body.cpp CONTENT
    "#include <kanexpr/flexible/kanexpr_flexible_body.cpp>\n" @ONLY)
  add_executable(kanexpr-flexible-body ${CMAKE_CURRENT_BINARY_DIR}/kanexpr_flexible_body.cpp)
  target_link_libraries(kanexpr-flexible-body PRIVATE kanexpr::flexible $<TARGET_NAME_IF_EXISTS:kanexpr::flexible_modes> CLI11::CLI11)
endfunction()
