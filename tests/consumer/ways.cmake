# Builds and runs this folder as a separate project, once for each way of using the library.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)

add_test(NAME consumer_install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
set_tests_properties(consumer_install PROPERTIES FIXTURES_SETUP installed)
foreach(installed IN ITEMS kanexpr_engine kanexpr_simulate_engine kanexpr_ensemble_engine kanexpr_hdf5_engine
    kanexpr_mpi_engine kanexpr_animate_engine kanexpr-robot kanexpr-flexible-body kanexpr-export)
  if(TARGET ${installed})
    kanexpr_of_room(consumer ${installed})
  endif()
endforeach()

# What CMake does is the same with every compiler; what compilers and linkers say to headers and libraries is not.
# clang++ gives all warnings to the headers when it compiles them alone; and what a program finds in a library of models
# are the same names.
set(ways engine)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND ways unfriendly linked add_subdirectory FetchContent find_package simulate robot)
else() # takes half the time there
  list(APPEND ways without_engine)
endif()
foreach(way IN LISTS ways)
  set(program consumer)
  if(way STREQUAL "unfriendly") # is read only
    set(program ${CMAKE_COMMAND} -E true)
  elseif(way STREQUAL "linked")
    set(program ${CMAKE_COMMAND} -DDIRECTORY=linked -P ${CMAKE_CURRENT_SOURCE_DIR}/linked/compare.cmake)
  endif()
  add_test(NAME consumer_${way}
    COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/${way}
      --build-generator ${CMAKE_GENERATOR}
      --build-options -DWAY=${way} -DKANEXPR_SOURCE=${PROJECT_SOURCE_DIR} -DCMAKE_PREFIX_PATH=${prefix}
        -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS} # how often g++ collects its garbage
      --test-command ${program})
endforeach()
foreach(way IN ITEMS find_package engine without_engine simulate linked robot)
  if(TEST consumer_${way})
    set_tests_properties(consumer_${way} PROPERTIES FIXTURES_REQUIRED installed)
  endif()
endforeach()

# Packages, and the single header: the same for every compiler
set(folder ${CMAKE_CURRENT_BINARY_DIR})
find_program(KANEXPR_PKG_CONFIG NAMES pkg-config)
if(KANEXPR_PKG_CONFIG AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  find_program(KANEXPR_DPKG NAMES dpkg)
  if(KANEXPR_DPKG) # calls pkg_config, too
    add_test(NAME consumer_debian COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/debian ${PROJECT_BINARY_DIR} ${folder}/debian
      ${CMAKE_CXX_COMPILER})
    set_tests_properties(consumer_debian PROPERTIES FIXTURES_REQUIRED installed)
  else()
    add_test(NAME consumer_pkg_config COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/pkg_config ${prefix} ${folder}/pkg_config
      ${CMAKE_CXX_COMPILER})
    set_tests_properties(consumer_pkg_config PROPERTIES FIXTURES_REQUIRED installed)
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang") # is quicker
  add_test(NAME consumer_single_header COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/single_header ${PROJECT_SOURCE_DIR}
    ${folder}/single_header ${PROJECT_BINARY_DIR}/tests/docs/snippets/README/printed.text ${CMAKE_CXX_COMPILER} -std=c++20 -isystem ${EIGEN3_INCLUDE_DIR}
      ${options_of_clang})
endif()

# each takes long and uses one processor
foreach(test IN ITEMS install unfriendly linked single_header debian without_engine pkg_config)
  if(TEST consumer_${test})
    set_tests_properties(consumer_${test} PROPERTIES COST 100)
  endif()
endforeach()

# The files that a packager receives, and the messages that a consumer receives. Nothing is compiled there, so one build
# suffices.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_test(NAME consumer_packages COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR}
    -DBINARY=${CMAKE_CURRENT_BINARY_DIR}/packages -DGENERATOR=${CMAKE_GENERATOR} -P ${CMAKE_CURRENT_SOURCE_DIR}/packages.cmake)
endif()
