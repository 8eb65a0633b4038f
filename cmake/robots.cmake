# kanexpr::robots: robots from URDF files. Requires tinyxml2; the command kanexpr-robot, which writes models, also requires CLI11.
# kanexpr::robots_sdf: the same from SDF files. Also requires libsdformat.
if(kanexpr_robots_lacks)
  message(STATUS "kanexpr::robots is disabled: ${kanexpr_robots_lacks}")
  return()
endif()

add_library(kanexpr_robots INTERFACE)
add_library(kanexpr::robots ALIAS kanexpr_robots)
set_target_properties(kanexpr_robots PROPERTIES EXPORT_NAME robots)
target_link_libraries(kanexpr_robots INTERFACE kanexpr tinyxml2::tinyxml2)
install(TARGETS kanexpr_robots EXPORT kanexpr-robots-targets)
install(EXPORT kanexpr-robots-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
kanexpr_pkgconfig(robots "Models of robots from URDF files" REQUIRES kanexpr tinyxml2)

if(kanexpr_robots_sdf_lacks)
  message(STATUS "kanexpr::robots_sdf is disabled: ${kanexpr_robots_sdf_lacks}")
else()
  add_library(kanexpr_robots_sdf INTERFACE)
  add_library(kanexpr::robots_sdf ALIAS kanexpr_robots_sdf)
  set_target_properties(kanexpr_robots_sdf PROPERTIES EXPORT_NAME robots_sdf)
  target_compile_definitions(kanexpr_robots_sdf INTERFACE KANEXPR_ROBOTS_READ_SDF)
  target_link_libraries(kanexpr_robots_sdf INTERFACE kanexpr_robots sdformat12::sdformat12)
  install(TARGETS kanexpr_robots_sdf EXPORT kanexpr-robots_sdf-targets)
  install(EXPORT kanexpr-robots_sdf-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
endif()

# The commands are installed for interactive use; kanexpr_add_robot.cmake also calls kanexpr-robot in projects.
find_package(CLI11 QUIET)
if(PROJECT_IS_TOP_LEVEL AND KANEXPR_BUILD_ENGINE AND CLI11_FOUND)
  add_executable(kanexpr-robot ${PROJECT_SOURCE_DIR}/include/kanexpr/robots/kanexpr_robot.cpp)
  target_link_libraries(kanexpr-robot PRIVATE kanexpr_engine kanexpr_robots $<TARGET_NAME_IF_EXISTS:kanexpr_robots_sdf>
    kanexpr_strict CLI11::CLI11)
  add_executable(kanexpr-export ${PROJECT_SOURCE_DIR}/include/kanexpr/exporting/kanexpr_export.cpp)
  target_link_libraries(kanexpr-export PRIVATE kanexpr_engine kanexpr_robots $<TARGET_NAME_IF_EXISTS:kanexpr_robots_sdf>
    $<TARGET_NAME_IF_EXISTS:kanexpr_fmi> kanexpr_strict CLI11::CLI11)
  # kanexpr-export passes these options to the compiler of a model.
  target_compile_definitions(kanexpr-export PRIVATE KANEXPR_EIGEN="$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>")
  if(TARGET kanexpr_fmi)
    string(CONCAT options_for_fmi "-idirafter '${kanexpr_zip_include}' -idirafter '$<TARGET_PROPERTY:tinyxml2::tinyxml2,INTERFACE_INCLUDE_DIRECTORIES>' "
      "'$<TARGET_FILE:tinyxml2::tinyxml2>' '${kanexpr_zip_library}'")
    target_compile_definitions(kanexpr-export PRIVATE "KANEXPR_FMI_OPTIONS=\"${options_for_fmi}\"")
  endif()
  install(TARGETS kanexpr-robot kanexpr-export RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
