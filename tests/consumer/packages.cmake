# Configures the library as a packager would, without optional dependencies, and as a consumer of the result would;
# checks the messages that they receive.
file(REMOVE_RECURSE ${BINARY})

# The package recipes have the version of the library.
include(${SOURCE}/cmake/version.cmake)
foreach(line IN ITEMS "package.xml:<version>${kanexpr_version}</version>"
    "cmake/packages/vcpkg/kanexpr/vcpkg.json:\"version\": \"${kanexpr_version}\"" "CITATION.cff:version: ${kanexpr_version}")
  string(FIND ${line} ":" colon)
  string(SUBSTRING ${line} 0 ${colon} file)
  math(EXPR colon "${colon} + 1")
  string(SUBSTRING ${line} ${colon} -1 text)
  file(READ ${SOURCE}/${file} contents)
  string(FIND "${contents}" "${text}" found)
  if(found EQUAL -1)
    message(SEND_ERROR "${file} does not contain ${text}")
  endif()
endforeach()

function(run expected pattern)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if((expected STREQUAL "passes") EQUAL (NOT result EQUAL 0))
    message(SEND_ERROR "${ARGN} ends with ${result}:\n${out}")
  endif()
  string(REGEX REPLACE "[ \n]+" " " said "${out}")
  string(FIND "${said}" "${pattern}" found)
  if(found EQUAL -1)
    message(SEND_ERROR "${ARGN} does not say \"${pattern}\":\n${out}")
  endif()
endfunction()

# build(<name> <expected message> <option>...): configures and builds; without the engine, this compiles nothing.
function(build name pattern)
  run(passes "${pattern}" ${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY}/${name} -G ${GENERATOR}
    -DKANEXPR_BUILD_ENGINE=OFF ${ARGN})
  run(passes "" ${CMAKE_COMMAND} --build ${BINARY}/${name})
  file(GLOB_RECURSE built ${BINARY}/${name}/*.o ${BINARY}/${name}/*.obj)
  list(FILTER built EXCLUDE REGEX "/CMakeFiles/[0-9.]+/")
  if(built)
    message(SEND_ERROR "a plain configure builds ${built}")
  endif()
endfunction()

# find(<expected result> <expected message> <prefix> <argument of find_package>...)
function(find expected pattern prefix)
  list(JOIN ARGN " " arguments)
  file(WRITE ${BINARY}/consumer/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(kanexpr ${arguments})
foreach(part engine simulate animate fmi)
  if(kanexpr_FOUND AND TARGET kanexpr::\${part})
    message(STATUS \"there is \${part}\")
  endif()
endforeach()
")
  run(${expected} "${pattern}" ${CMAKE_COMMAND} -S ${BINARY}/consumer -B ${BINARY}/consumer/build -G ${GENERATOR} -U kanexpr_DIR
    -DCMAKE_PREFIX_PATH=${BINARY}/${prefix})
endfunction()

set(without_sundials -DCMAKE_DISABLE_FIND_PACKAGE_SUNDIALS=ON)
set(without_json -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON)
set(without_tinyxml2 -DCMAKE_DISABLE_FIND_PACKAGE_tinyxml2=ON)
set(without_sdformat -DCMAKE_DISABLE_FIND_PACKAGE_sdformat12=ON)
build(poor "kanexpr::simulate is disabled: SUNDIALS 6.4 was not found" -DKANEXPR_NPM=KANEXPR_NPM-NOTFOUND
  -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON ${without_sundials} ${without_json} ${without_tinyxml2})
run(passes "kanexpr::animate is disabled: nlohmann-json 3.2 was not found" ${CMAKE_COMMAND} ${BINARY}/poor)
run(passes "kanexpr::robots is disabled: tinyxml2 was not found" ${CMAKE_COMMAND} ${BINARY}/poor)
run(passes "kanexpr::fmi is disabled: tinyxml2 was not found" ${CMAKE_COMMAND} ${BINARY}/poor)
run(passes "" ${CMAKE_COMMAND} --install ${BINARY}/poor --prefix ${BINARY}/little)
foreach(part engine simulate fmi robots robots_sdf)
  find(fails "kanexpr::${part} is disabled: kanexpr was installed without it" little REQUIRED COMPONENTS ${part})
endforeach()

# All optional parts except the page, and then also the page
build(rich "kanexpr::robots_sdf is disabled: libsdformat 12 was not found; on Debian, install libsdformat-dev" ${without_sdformat})
run(passes "only if its page was built" ${CMAKE_COMMAND} ${BINARY}/rich)
run(passes "kanexpr::animate is disabled: its page was not built" ${CMAKE_COMMAND} --install ${BINARY}/rich
  --prefix ${BINARY}/most)
find(passes "there is simulate" most REQUIRED COMPONENTS simulate)
find(passes "there is fmi" most REQUIRED COMPONENTS fmi)
find(passes "kanexpr::animate is disabled: the animation page was not installed" most REQUIRED)
find(fails "kanexpr::animate is disabled: the animation page was not installed" most REQUIRED
  COMPONENTS animate)
find(fails "kanexpr has no component simulation" most REQUIRED COMPONENTS simulation)
find(passes "there is simulate" most 0.2...<0.3 REQUIRED OPTIONAL_COMPONENTS simulate animate)
find(fails "compatible with requested version range" most 0.3...<1 REQUIRED)
file(WRITE ${BINARY}/rich/page/kanexpr.html "a page")
run(passes "share/kanexpr/kanexpr.html" ${CMAKE_COMMAND} --install ${BINARY}/rich --prefix ${BINARY}/all)
find(passes "there is animate" all REQUIRED COMPONENTS simulate animate)
