# kanexpr::simulate: the part that needs SUNDIALS. Where that is not there the target is not either.
find_package(SUNDIALS 6.4 QUIET COMPONENTS cvode arkode ida kinsol nvecserial sunmatrixdense sunlinsoldense
  sunnonlinsolfixedpoint)
# Whether all was found does not matter: a compiler without OpenMP is enough, which only parts need that are not used.
if(NOT TARGET SUNDIALS::cvode)
  message(STATUS "SUNDIALS is not installed: there is no kanexpr::simulate")
  return()
endif()

add_library(kanexpr_simulate INTERFACE)
add_library(kanexpr::simulate ALIAS kanexpr_simulate)
set_target_properties(kanexpr_simulate PROPERTIES EXPORT_NAME simulate)
target_link_libraries(kanexpr_simulate INTERFACE kanexpr
  SUNDIALS::cvode SUNDIALS::arkode SUNDIALS::ida SUNDIALS::kinsol SUNDIALS::nvecserial SUNDIALS::sunmatrixdense
  SUNDIALS::sunlinsoldense SUNDIALS::sunnonlinsolfixedpoint)
install(TARGETS kanexpr_simulate EXPORT kanexpr-simulate-targets)
install(EXPORT kanexpr-simulate-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
