# kanexpr::fmi: FMUs, which simulation tools import. Requires tinyxml2 and libzip.
if(kanexpr_fmi_lacks)
  message(STATUS "kanexpr::fmi is disabled: ${kanexpr_fmi_lacks}")
  return()
endif()

add_library(kanexpr_fmi INTERFACE)
add_library(kanexpr::fmi ALIAS kanexpr_fmi)
set_target_properties(kanexpr_fmi PROPERTIES EXPORT_NAME fmi)
target_link_libraries(kanexpr_fmi INTERFACE kanexpr tinyxml2::tinyxml2 kanexpr_zip)
install(TARGETS kanexpr_fmi EXPORT kanexpr-fmi-targets)
install(EXPORT kanexpr-fmi-targets NAMESPACE kanexpr:: DESTINATION ${kanexpr_package_dir})
kanexpr_pkgconfig(fmi "FMUs of kanexpr's models" REQUIRES kanexpr tinyxml2 libzip)
