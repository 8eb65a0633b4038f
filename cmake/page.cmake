# kanexpr::animate: animations of systems as pages for a browser. Requires nlohmann-json, and npm for the page itself.
find_program(KANEXPR_NPM npm DOC "npm, which builds the animation page")

# kanexpr_npm_install(<variable> <source directory> <directory> <file>...): copies the files and installs the packages
# that are pinned in the package-lock.json next to them. Sets the variable to the file that other rules must depend on.
function(kanexpr_npm_install result from to)
  set(files package.json package-lock.json .npmrc ${ARGN})
  list(TRANSFORM files PREPEND ${from}/ OUTPUT_VARIABLE sources)
  set(pinned ${from}/package.json ${from}/package-lock.json ${from}/.npmrc)
  add_custom_command(OUTPUT ${to}/installed DEPENDS ${pinned}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${to}
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${pinned} ${to}
    COMMAND ${CMAKE_COMMAND} -E chdir ${to} ${KANEXPR_NPM} ci --ignore-scripts --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${to}/installed
    COMMENT "Installing the packages of ${to}" VERBATIM)
  add_custom_command(OUTPUT ${to}/copied DEPENDS ${sources} ${to}/installed
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${sources} ${to}
    COMMAND ${CMAKE_COMMAND} -E touch ${to}/copied VERBATIM)
  set(${result} ${to}/copied PARENT_SCOPE)
endfunction()

set(KANEXPR_PAGE ${PROJECT_BINARY_DIR}/page/kanexpr.html)
if(KANEXPR_NPM)
  set(page_sources ${PROJECT_SOURCE_DIR}/include/kanexpr/animate/page)
  file(GLOB page_files CONFIGURE_DEPENDS RELATIVE ${page_sources}
    ${page_sources}/*.js ${page_sources}/*.css ${page_sources}/*.html)
  kanexpr_npm_install(installed ${page_sources} ${PROJECT_BINARY_DIR}/page ${page_files})
  add_custom_command(OUTPUT ${KANEXPR_PAGE} DEPENDS ${installed}
    COMMAND ${KANEXPR_NPM} run --silent build -- ${KANEXPR_PAGE}
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/page
    COMMENT "Building the animation page" VERBATIM)
  add_custom_target(kanexpr_page DEPENDS ${KANEXPR_PAGE})
else()
  add_custom_target(kanexpr_page
    COMMAND ${CMAKE_COMMAND} -E echo "The animation page requires npm, which was not found."
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()

if(kanexpr_animate_lacks)
  message(STATUS "kanexpr::animate is disabled: ${kanexpr_animate_lacks}")
  return()
endif()
add_library(kanexpr_animate INTERFACE)
add_library(kanexpr::animate ALIAS kanexpr_animate)
set_target_properties(kanexpr_animate PROPERTIES EXPORT_NAME animate)
target_link_libraries(kanexpr_animate INTERFACE kanexpr nlohmann_json::nlohmann_json)
target_compile_definitions(kanexpr_animate INTERFACE
  $<BUILD_INTERFACE:KANEXPR_PAGE="${KANEXPR_PAGE}">
  $<INSTALL_INTERFACE:KANEXPR_PAGE="$<INSTALL_PREFIX>/${kanexpr_page}">)
# A plain build of kanexpr itself needs neither npm nor a network.
if(KANEXPR_NPM AND (NOT PROJECT_IS_TOP_LEVEL OR KANEXPR_BUILD_PAGE OR KANEXPR_BUILD_TESTS OR KANEXPR_BUILD_EXAMPLES))
  add_dependencies(kanexpr_animate kanexpr_page)
endif()
install(TARGETS kanexpr_animate EXPORT kanexpr-animate-targets)
install(EXPORT kanexpr-animate-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
kanexpr_pkgconfig(animate "Animated pages of kanexpr's models; page_options::empty_page is share/kanexpr/kanexpr.html"
  REQUIRES kanexpr nlohmann_json ONLY_WITH ${KANEXPR_PAGE})
kanexpr_add_engine_of(animate PAGES ONLY_WITH ${KANEXPR_PAGE})

# The installed package omits the target if the page is missing.
cmake_path(GET kanexpr_page PARENT_PATH kanexpr_page_dir)
install(FILES ${KANEXPR_PAGE} DESTINATION ${kanexpr_page_dir} OPTIONAL)
set(reason "its page was not built; build it with npm by the target kanexpr_page or the option KANEXPR_BUILD_PAGE")
install(CODE "
  if(NOT EXISTS \"${KANEXPR_PAGE}\")
    message(STATUS \"kanexpr::animate is disabled: ${reason}\")
  endif()")
if(PROJECT_IS_TOP_LEVEL)
  option(KANEXPR_BUILD_PAGE "Build the animation page (requires npm and network access)" OFF)
  if(KANEXPR_BUILD_PAGE)
    set_target_properties(kanexpr_page PROPERTIES EXCLUDE_FROM_ALL OFF)
  else()
    message(STATUS "kanexpr::animate is installed only if its page was built by KANEXPR_BUILD_PAGE or the target kanexpr_page")
  endif()
endif()
