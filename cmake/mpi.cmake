# kanexpr::mpi: studies on the ranks of MPI, on any number of machines.
if(kanexpr_mpi_lacks)
  message(STATUS "kanexpr::mpi is disabled: ${kanexpr_mpi_lacks}")
  return()
endif()

add_library(kanexpr_mpi INTERFACE)
add_library(kanexpr::mpi ALIAS kanexpr_mpi)
set_target_properties(kanexpr_mpi PROPERTIES EXPORT_NAME mpi)
target_link_libraries(kanexpr_mpi INTERFACE kanexpr_ensemble MPI::MPI_CXX)
# Without this definition, the MPI headers would include C++ classes that were removed from the standard in 2012.
target_compile_definitions(kanexpr_mpi INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
install(TARGETS kanexpr_mpi EXPORT kanexpr-mpi-targets)
install(EXPORT kanexpr-mpi-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})

kanexpr_pkgconfig(mpi "Many simulations on the ranks of MPI; compile with mpicxx" REQUIRES kanexpr-ensemble
  CFLAGS -DOMPI_SKIP_MPICXX -DMPICH_SKIP_MPICXX)
kanexpr_add_engine_of(mpi MPI USES ensemble)
