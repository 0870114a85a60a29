# cpack: a .deb for Debian's ParaView and a .tar.gz with the same files.
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME paraview-strata)
# A name alone: the project has no address of its own.
set(CPACK_PACKAGE_CONTACT "The Strata developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}: a ParaView plugin")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Without Qt's plugin for SVG a window shows no icons, neither ours nor ParaView's own, and complains about it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "paraview (>= 5.11), paraview (<< 5.12), libqt5svg5")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS python3-paraview)

# One package from the components that a user needs; the static wrapper libraries stay out.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL paraview_plugins python)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
include(CPack)
