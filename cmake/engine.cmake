# kanexpr::engine: the run-time part of the library, compiled once. With only kanexpr::kanexpr, every file that uses it
# compiles it.

# kanexpr_add_engine(<name>): the engine compiled with the flags of the directory.
#
# The sources are stored and installed with the headers that they compile, for builds without CMake.
function(kanexpr_add_engine name)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/kanexpr/engine/*.cpp)
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC kanexpr)
  target_compile_definitions(${name} PUBLIC KANEXPR_COMPILED_ENGINE)
  # Eigen's functions differ between files compiled with different vector instructions. Therefore, the engine uses a copy
  # of Eigen under a different name, and its declarations do not mention Eigen.
  target_compile_definitions(${name} PRIVATE Eigen=kanexpr_engine_eigen KANEXPR_WITHIN_A_LIBRARY)
  # The results of the engine are bitwise identical with all compilers.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
endfunction()

# kanexpr_add_engine_of(<part> <what> [FOLDER <folder>] [USES <other part>] [ONLY_WITH <file>]): the engine of a part with additional
# dependencies, kanexpr::<part>_engine, which may use the engine of another part. Its sources are in the folder named after the part,
# or in <folder>. ONLY_WITH is passed to kanexpr_pkgconfig.
function(kanexpr_add_engine_of part what)
  cmake_parse_arguments(PARSE_ARGV 2 engine "" "FOLDER;USES;ONLY_WITH" "")
  set(name kanexpr_${part}_engine)
  set(folder ${part})
  if(engine_FOLDER)
    set(folder ${engine_FOLDER})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/kanexpr/${folder}/*.cpp)
  add_library(${name} STATIC ${sources})
  add_library(kanexpr::${part}_engine ALIAS ${name})
  target_link_libraries(${name} PUBLIC kanexpr_${part})
  set(packages kanexpr-${part})
  if(engine_USES)
    target_link_libraries(${name} PUBLIC kanexpr_${engine_USES}_engine)
    list(PREPEND packages kanexpr-${engine_USES}-engine) # a linker searches libraries in this order
  endif()
  target_compile_definitions(${name} PUBLIC KANEXPR_COMPILED_${what} PRIVATE KANEXPR_WITHIN_A_LIBRARY)
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${part}_engine
    OPTIMIZE_DEPENDENCIES ON) # does not depend on the animation page
  if(KANEXPR_BUILD_ENGINE)
    install(TARGETS ${name} EXPORT kanexpr-${part}_engine-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT kanexpr-${part}_engine-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
    kanexpr_pkgconfig(${part}_engine "kanexpr-${part} with the parts that do not depend on the model as a library"
      REQUIRES ${packages} CFLAGS -DKANEXPR_COMPILED_${what} LIBS -L\${libdir} -l${name} ONLY_WITH "${engine_ONLY_WITH}")
  else()
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()

kanexpr_add_engine(kanexpr_engine)
add_library(kanexpr::engine ALIAS kanexpr_engine)
set_target_properties(kanexpr_engine PROPERTIES EXPORT_NAME engine)
if(KANEXPR_BUILD_ENGINE)
  install(TARGETS kanexpr_engine EXPORT kanexpr-engine-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT kanexpr-engine-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
  kanexpr_pkgconfig(engine "kanexpr with the parts that do not depend on the model as a library"
    REQUIRES kanexpr CFLAGS -DKANEXPR_COMPILED_ENGINE LIBS -L\${libdir} -lkanexpr_engine)
else() # also if this project is part of another one
  set_target_properties(kanexpr_engine PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
