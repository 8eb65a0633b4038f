# kanexpr::engine: what works while a program runs, compiled once. With kanexpr::kanexpr alone every file that uses it
# compiles it.

# kanexpr_add_engine(<name>): the engine compiled with the flags of the directory.
#
# The sources lie with the headers that they compile, and are installed with them, for those who build without CMake.
function(kanexpr_add_engine name)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/kanexpr/engine/*.cpp)
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC kanexpr)
  target_compile_definitions(${name} PUBLIC KANEXPR_COMPILED_ENGINE)
  # Eigen's functions are others where a program is compiled with other vector instructions. So the engine has an Eigen
  # of its own, by another name, and none of its declarations speaks of Eigen.
  target_compile_definitions(${name} PRIVATE Eigen=kanexpr_engine_eigen KANEXPR_WITHIN_A_LIBRARY)
  # Its results are the same to the last bit wherever it is compiled.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
endfunction()

# kanexpr_add_engine_of(<part> <what> [<folder>]): the same of a part that needs more, kanexpr::<part>_engine. Its
# sources lie in a folder of its name, or another one.
function(kanexpr_add_engine_of part what)
  set(name kanexpr_${part}_engine)
  set(folder ${ARGN} ${part})
  list(GET folder 0 folder)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/kanexpr/${folder}/engine/*.cpp)
  add_library(${name} STATIC ${sources})
  add_library(kanexpr::${part}_engine ALIAS ${name})
  target_link_libraries(${name} PUBLIC kanexpr_${part})
  target_compile_definitions(${name} PUBLIC KANEXPR_COMPILED_${what} PRIVATE KANEXPR_WITHIN_A_LIBRARY)
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${part}_engine
    OPTIMIZE_DEPENDENCIES ON) # not the page on which systems move
  if(KANEXPR_BUILD_ENGINE)
    install(TARGETS ${name} EXPORT kanexpr-${part}_engine-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT kanexpr-${part}_engine-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
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
else() # of a project that this one is a part of, too
  set_target_properties(kanexpr_engine PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
