include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(kanexpr_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/kanexpr)

install(DIRECTORY include/kanexpr DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp"
  PATTERN "*.ipp" PATTERN "*.in" PATTERN "*.cpp" PATTERN page EXCLUDE)
install(TARGETS kanexpr EXPORT kanexpr-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT kanexpr-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})

set(kanexpr_page ${CMAKE_INSTALL_DATADIR}/kanexpr/kanexpr.html)
set(kanexpr_installed_robot_command ${CMAKE_INSTALL_BINDIR}/kanexpr-robot)
set(kanexpr_installed_flexible_body_command ${CMAKE_INSTALL_BINDIR}/kanexpr-flexible-body)
configure_package_config_file(cmake/kanexpr-config.cmake.in ${PROJECT_BINARY_DIR}/kanexpr-config.cmake
  INSTALL_DESTINATION ${kanexpr_package_dir} PATH_VARS kanexpr_page kanexpr_installed_robot_command
  kanexpr_installed_flexible_body_command)
# A package that contains only headers can be used for both 32 and 64 bits.
set(kanexpr_serves)
if(NOT KANEXPR_BUILD_ENGINE)
  set(kanexpr_serves ARCH_INDEPENDENT)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kanexpr-config-version.cmake
  COMPATIBILITY SameMinorVersion ${kanexpr_serves})
install(FILES ${PROJECT_BINARY_DIR}/kanexpr-config.cmake ${PROJECT_BINARY_DIR}/kanexpr-config-version.cmake
  cmake/parts.cmake cmake/kanexpr_add_model.cmake cmake/kanexpr_add_robot.cmake cmake/kanexpr_add_flexible_body.cmake
  cmake/kanexpr_export.cmake DESTINATION ${kanexpr_package_dir})
