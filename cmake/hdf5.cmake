# kanexpr::hdf5: HDF5 files for the results of ensembles.
if(kanexpr_hdf5_lacks)
  message(STATUS "kanexpr::hdf5 is disabled: ${kanexpr_hdf5_lacks}")
  return()
endif()

add_library(kanexpr_hdf5 INTERFACE)
add_library(kanexpr::hdf5 ALIAS kanexpr_hdf5)
set_target_properties(kanexpr_hdf5 PROPERTIES EXPORT_NAME hdf5)
target_link_libraries(kanexpr_hdf5 INTERFACE kanexpr_ensemble kanexpr_hdf5_c)
install(TARGETS kanexpr_hdf5 EXPORT kanexpr-hdf5-targets)
install(EXPORT kanexpr-hdf5-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})

kanexpr_pkgconfig(hdf5 "HDF5 files for the results of many simulations" REQUIRES kanexpr-ensemble
  CFLAGS -I${kanexpr_hdf5_include} LIBS ${kanexpr_hdf5_library})
kanexpr_add_engine_of(hdf5 HDF5 FOLDER ensembles/hdf5 USES ensemble)
