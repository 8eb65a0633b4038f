# kanexpr::flexible: flexible bodies from files with standard input data. The command kanexpr-flexible-body, which writes such bodies as
# headers, also requires CLI11.
# kanexpr::flexible_modes: the same from modes in JSON files. Also requires nlohmann-json.
add_library(kanexpr_flexible INTERFACE)
add_library(kanexpr::flexible ALIAS kanexpr_flexible)
set_target_properties(kanexpr_flexible PROPERTIES EXPORT_NAME flexible)
target_link_libraries(kanexpr_flexible INTERFACE kanexpr)
install(TARGETS kanexpr_flexible EXPORT kanexpr-flexible-targets)
install(EXPORT kanexpr-flexible-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
kanexpr_pkgconfig(flexible "Flexible bodies from files" REQUIRES kanexpr)

if(kanexpr_flexible_modes_lacks)
  message(STATUS "kanexpr::flexible_modes is disabled: ${kanexpr_flexible_modes_lacks}")
else()
  add_library(kanexpr_flexible_modes INTERFACE)
  add_library(kanexpr::flexible_modes ALIAS kanexpr_flexible_modes)
  set_target_properties(kanexpr_flexible_modes PROPERTIES EXPORT_NAME flexible_modes)
  target_compile_definitions(kanexpr_flexible_modes INTERFACE KANEXPR_FLEXIBLE_READ_MODES)
  target_link_libraries(kanexpr_flexible_modes INTERFACE kanexpr_flexible nlohmann_json::nlohmann_json)
  install(TARGETS kanexpr_flexible_modes EXPORT kanexpr-flexible_modes-targets)
  install(EXPORT kanexpr-flexible_modes-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
  kanexpr_pkgconfig(flexible_modes "Flexible bodies from modes in JSON files" REQUIRES kanexpr-flexible nlohmann_json
    CFLAGS -DKANEXPR_FLEXIBLE_READ_MODES)
endif()

find_package(CLI11 QUIET)
if(PROJECT_IS_TOP_LEVEL AND KANEXPR_BUILD_ENGINE AND CLI11_FOUND)
  add_executable(kanexpr-flexible-body ${PROJECT_SOURCE_DIR}/include/kanexpr/flexible/kanexpr_flexible_body.cpp)
  target_link_libraries(kanexpr-flexible-body PRIVATE kanexpr_flexible $<TARGET_NAME_IF_EXISTS:kanexpr_flexible_modes>
    kanexpr_strict CLI11::CLI11)
  install(TARGETS kanexpr-flexible-body RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
