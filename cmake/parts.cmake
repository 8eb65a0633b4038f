# The missing requirements of the compiler and of the parts of kanexpr, for its build and for its package:
# kanexpr_<part>_lacks is empty if nothing is missing, and a sentence otherwise.
set(kanexpr_compiler_lacks "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
  set(kanexpr_compiler_lacks "kanexpr requires g++ 12 or later, or clang; found g++ ${CMAKE_CXX_COMPILER_VERSION}")
endif()

find_package(SUNDIALS 6.4 QUIET COMPONENTS cvode arkode ida kinsol nvecserial sunmatrixdense sunlinsoldense
  sunnonlinsolfixedpoint)
# SUNDIALS_FOUND is not checked: it is false without OpenMP, which only unused components need.
set(kanexpr_simulate_lacks "")
if(NOT TARGET SUNDIALS::cvode)
  set(kanexpr_simulate_lacks "SUNDIALS 6.4 was not found")
endif()

find_package(Threads QUIET)
set(kanexpr_ensemble_lacks "${kanexpr_simulate_lacks}")
if(NOT kanexpr_ensemble_lacks AND NOT TARGET Threads::Threads)
  set(kanexpr_ensemble_lacks "threads were not found")
endif()

find_package(MPI 3.0 QUIET COMPONENTS CXX)
set(kanexpr_mpi_lacks "${kanexpr_ensemble_lacks}")
if(NOT kanexpr_mpi_lacks AND NOT TARGET MPI::MPI_CXX)
  set(kanexpr_mpi_lacks "MPI was not found; on Debian, install libopenmpi-dev and openmpi-bin")
endif()

# CMake's own module requires the language C. Debian also has the library for MPI, with different headers.
find_path(kanexpr_hdf5_include hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(kanexpr_hdf5_library NAMES hdf5_serial hdf5 PATH_SUFFIXES hdf5/serial)
mark_as_advanced(kanexpr_hdf5_include kanexpr_hdf5_library)
set(kanexpr_hdf5_lacks "${kanexpr_ensemble_lacks}")
set(kanexpr_hdf5_version 0)
set(kanexpr_hdf5_parallel)
if(kanexpr_hdf5_include AND kanexpr_hdf5_library)
  file(STRINGS ${kanexpr_hdf5_include}/H5public.h kanexpr_hdf5_version REGEX "define H5_VERS_INFO ")
  string(REGEX REPLACE ".* ([0-9.]+).*" "\\1" kanexpr_hdf5_version "${kanexpr_hdf5_version}")
  file(GLOB kanexpr_hdf5_settings ${kanexpr_hdf5_include}/H5pubconf*.h)
  foreach(kanexpr_hdf5_file IN LISTS kanexpr_hdf5_settings)
    file(STRINGS ${kanexpr_hdf5_file} kanexpr_hdf5_found REGEX "define H5_HAVE_PARALLEL ")
    list(APPEND kanexpr_hdf5_parallel ${kanexpr_hdf5_found})
  endforeach()
endif()
if(NOT kanexpr_hdf5_lacks AND (kanexpr_hdf5_version VERSION_LESS 1.10.2 OR kanexpr_hdf5_parallel))
  set(kanexpr_hdf5_lacks "HDF5 1.10.2, without MPI, was not found; on Debian, install libhdf5-dev")
endif()
if(NOT kanexpr_hdf5_lacks AND NOT TARGET kanexpr_hdf5_c)
  add_library(kanexpr_hdf5_c UNKNOWN IMPORTED GLOBAL)
  set_target_properties(kanexpr_hdf5_c PROPERTIES IMPORTED_LOCATION ${kanexpr_hdf5_library}
    INTERFACE_INCLUDE_DIRECTORIES ${kanexpr_hdf5_include})
endif()

find_package(nlohmann_json 3.2 QUIET)
set(kanexpr_animate_lacks "")
if(NOT nlohmann_json_FOUND)
  set(kanexpr_animate_lacks "nlohmann-json 3.2 was not found")
endif()

find_package(tinyxml2 QUIET)
set(kanexpr_robots_lacks "")
if(NOT TARGET tinyxml2::tinyxml2)
  set(kanexpr_robots_lacks "tinyxml2 was not found")
endif()

# The file for CMake that Debian installs with libzip requires programs of other packages.
find_path(kanexpr_zip_include zip.h)
find_library(kanexpr_zip_library zip)
mark_as_advanced(kanexpr_zip_include kanexpr_zip_library)
set(kanexpr_fmi_lacks "${kanexpr_robots_lacks}")
if(NOT kanexpr_fmi_lacks AND NOT (kanexpr_zip_include AND kanexpr_zip_library))
  set(kanexpr_fmi_lacks "libzip was not found; on Debian, install libzip-dev")
endif()
if(NOT kanexpr_fmi_lacks AND NOT TARGET kanexpr_zip)
  add_library(kanexpr_zip UNKNOWN IMPORTED GLOBAL)
  set_target_properties(kanexpr_zip PROPERTIES IMPORTED_LOCATION ${kanexpr_zip_library}
    INTERFACE_INCLUDE_DIRECTORIES ${kanexpr_zip_include})
endif()

# It prints messages about its search even if it is called with QUIET.
set(kanexpr_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
find_package(sdformat12 QUIET)
set(CMAKE_MESSAGE_LOG_LEVEL "${kanexpr_log_level}")
set(kanexpr_robots_sdf_lacks "${kanexpr_robots_lacks}")
if(NOT kanexpr_robots_lacks AND NOT TARGET sdformat12::sdformat12)
  set(kanexpr_robots_sdf_lacks "libsdformat 12 was not found; on Debian, install libsdformat-dev")
endif()
