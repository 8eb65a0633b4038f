# Builds from the checkout that contains this port; a release replaces the first two lines with vcpkg_from_github.
cmake_path(SET source NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../../..")
set(SOURCE_PATH "${source}")

set(VCPKG_BUILD_TYPE release) # nothing is compiled
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DKANEXPR_BUILD_ENGINE=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME kanexpr CONFIG_PATH share/cmake/kanexpr)
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
