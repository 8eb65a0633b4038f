# kanexpr_add_robot(<target> URDF <file.urdf>|SDF <file.sdf> [BASE fixed|floating] [BIND numbers|parameters]
# [OPTIONS <option>...]): a header-only library. <target>.hpp contains the namespace <target> with System, the model of the robot;
# <target>_picture.hpp contains its picture for the pages of kanexpr::animate:
#
#     kanexpr_add_robot(panda URDF panda.urdf)
#     target_link_libraries(program PRIVATE panda)               # #include <panda.hpp>
#
# The command kanexpr-robot writes the headers; OPTIONS are passed to it. If kanexpr is installed, its command is used; otherwise, the
# command is compiled here, with tinyxml2 and CLI11. When cross-compiling, either CMAKE_CROSSCOMPILING_EMULATOR runs it, or
# kanexpr_ROBOT_COMMAND specifies a command that runs on the host.
function(kanexpr_add_robot target)
  cmake_parse_arguments(PARSE_ARGV 1 robot "" "URDF;SDF;BASE;BIND" "OPTIONS")
  set(file ${robot_URDF}${robot_SDF})
  if(NOT file OR (robot_URDF AND robot_SDF) OR robot_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "kanexpr_add_robot(<target> URDF <file.urdf>|SDF <file.sdf> [BASE fixed|floating] [BIND numbers|parameters] [OPTIONS <option>...])")
  endif()
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "kanexpr_add_robot: ${file} does not exist")
  endif()
  if(robot_SDF AND NOT TARGET kanexpr::robots_sdf AND NOT kanexpr_ROBOT_COMMAND)
    message(FATAL_ERROR "kanexpr_add_robot cannot read ${file}: ${kanexpr_robots_sdf_lacks}")
  endif()
  kanexpr_find_robot_command(command)
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/${target}_robot)
  set(header ${directory}/${target}.hpp)
  set(picture ${directory}/${target}_picture.hpp)
  set(options ${robot_OPTIONS})
  if(robot_BASE)
    list(APPEND options --base ${robot_BASE})
  endif()
  if(robot_BIND)
    list(APPEND options --bind ${robot_BIND})
  endif()
  file(MAKE_DIRECTORY ${directory})
  add_custom_command(OUTPUT ${header} ${picture}
    COMMAND ${command} ${file} --name ${target} --output ${header} --picture ${picture} ${options}
    DEPENDS ${file} ${command} COMMENT "Writing the model of ${target}" VERBATIM)
  add_custom_target(${target}_header DEPENDS ${header} ${picture})
  add_library(${target} INTERFACE ${file}) # with a source, so that building the target writes the headers
  add_dependencies(${target} ${target}_header)
  target_include_directories(${target} INTERFACE ${directory})
  target_link_libraries(${target} INTERFACE kanexpr::kanexpr)
endfunction()

# Sets the command that writes models: the specified one, the installed one, or one that is compiled once for all robots in
# the project.
function(kanexpr_find_robot_command command)
  set(${command} kanexpr-robot PARENT_SCOPE)
  if(kanexpr_ROBOT_COMMAND)
    set(${command} ${kanexpr_ROBOT_COMMAND} PARENT_SCOPE)
    return()
  elseif(TARGET kanexpr-robot)
    return()
  elseif(EXISTS "${kanexpr_installed_robot_command}" AND NOT CMAKE_CROSSCOMPILING)
    set(${command} ${kanexpr_installed_robot_command} PARENT_SCOPE)
    return()
  endif()
  find_package(CLI11 QUIET)
  if(NOT TARGET kanexpr::robots)
    message(FATAL_ERROR "kanexpr_add_robot requires kanexpr::robots: ${kanexpr_robots_lacks}")
  elseif(NOT CLI11_FOUND)
    message(FATAL_ERROR "kanexpr_add_robot requires CLI11, which was not found")
  endif()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/kanexpr_robot.cpp CONTENT
    "#include <kanexpr/robots/kanexpr_robot.cpp>\n" @ONLY)
  add_executable(kanexpr-robot ${CMAKE_CURRENT_BINARY_DIR}/kanexpr_robot.cpp)
  target_link_libraries(kanexpr-robot PRIVATE kanexpr::robots $<TARGET_NAME_IF_EXISTS:kanexpr::robots_sdf> CLI11::CLI11)
endfunction()
