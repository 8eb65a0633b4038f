# kanexpr::simulate: the part that requires SUNDIALS.
if(kanexpr_simulate_lacks)
  message(STATUS "kanexpr::simulate is disabled: ${kanexpr_simulate_lacks}")
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

kanexpr_pkgconfig(simulate "Simulations of kanexpr's models, by SUNDIALS" REQUIRES kanexpr LIBS -lsundials_cvode
  -lsundials_arkode -lsundials_ida -lsundials_kinsol -lsundials_nvecserial -lsundials_sunmatrixdense
  -lsundials_sunlinsoldense -lsundials_sunnonlinsolfixedpoint)
kanexpr_add_engine_of(simulate SIMULATIONS FOLDER simulations)
