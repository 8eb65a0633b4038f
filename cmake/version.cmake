# Sets kanexpr_version from the header that defines it.
set(version_header ${CMAKE_CURRENT_LIST_DIR}/../include/kanexpr/base/version.hpp)
file(STRINGS ${version_header} version_lines REGEX "^#define KANEXPR_VERSION_(MAJOR|MINOR|PATCH) [0-9]+$")
list(TRANSFORM version_lines REPLACE "^.* " "")
list(JOIN version_lines . kanexpr_version)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${version_header})
