# kanexpr_pkgconfig(<part> <description> REQUIRES <package>... [CFLAGS <option>...] [LIBS <option>...] [ONLY_WITH <file>]):
# installs kanexpr-<part>.pc, or kanexpr.pc if <part> is kanexpr; with ONLY_WITH, only if the file exists at that time. The
# files work wherever they are installed.
function(kanexpr_pkgconfig part description)
  cmake_parse_arguments(PARSE_ARGV 2 kanexpr_pc "" "ONLY_WITH" "REQUIRES;CFLAGS;LIBS")
  string(REPLACE "_" "-" part "${part}")
  set(kanexpr_pc_name kanexpr-${part})
  if(part STREQUAL "kanexpr")
    set(kanexpr_pc_name kanexpr)
  endif()
  set(kanexpr_pc_description "${description}")
  foreach(list IN ITEMS requires cflags libs)
    string(TOUPPER ${list} argument)
    list(JOIN kanexpr_pc_${argument} " " kanexpr_pc_${list})
  endforeach()
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH kanexpr_pc_prefix /${folder} /)
  string(REGEX REPLACE "/$" "" kanexpr_pc_prefix "${kanexpr_pc_prefix}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/packages/kanexpr.pc.in ${PROJECT_BINARY_DIR}/${kanexpr_pc_name}.pc @ONLY)
  if(kanexpr_pc_ONLY_WITH)
    install(CODE "
      if(EXISTS \"${kanexpr_pc_ONLY_WITH}\")
        file(INSTALL \"${PROJECT_BINARY_DIR}/${kanexpr_pc_name}.pc\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${folder}\")
      endif()")
  else()
    install(FILES ${PROJECT_BINARY_DIR}/${kanexpr_pc_name}.pc DESTINATION ${folder})
  endif()
endfunction()

# The options of the compiler with which this build is configured; a project with a different compiler uses the variable
# options_of_gcc or options_of_clang instead.
set(options ${kanexpr_options_of_gcc})
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(options ${kanexpr_options_of_clang})
endif()
kanexpr_pkgconfig(kanexpr "Equations of motion, derived while a program compiles" REQUIRES "eigen3 >= 3.4"
  CFLAGS "-std=c++20 -I\${includedir} ${options}")
