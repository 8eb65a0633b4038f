# kanexpr::ensemble: many simulations on the threads of one machine.
if(kanexpr_ensemble_lacks)
  message(STATUS "kanexpr::ensemble is disabled: ${kanexpr_ensemble_lacks}")
  return()
endif()

add_library(kanexpr_ensemble INTERFACE)
add_library(kanexpr::ensemble ALIAS kanexpr_ensemble)
set_target_properties(kanexpr_ensemble PROPERTIES EXPORT_NAME ensemble)
target_link_libraries(kanexpr_ensemble INTERFACE kanexpr_simulate Threads::Threads)
install(TARGETS kanexpr_ensemble EXPORT kanexpr-ensemble-targets)
install(EXPORT kanexpr-ensemble-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})

kanexpr_pkgconfig(ensemble "Many simulations on several threads" REQUIRES kanexpr-simulate LIBS -pthread)
kanexpr_add_engine_of(ensemble ENSEMBLES FOLDER ensembles USES simulate)
