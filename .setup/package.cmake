# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's package of the plugin, made by `bash edp/package`: ffcontact_VERSION_ARCHITECTURE.deb, for the FreeFEM it was built for.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The ffcontact developers <ffcontact@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "frictional contact with an error estimate, for FreeFEM")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL plugin)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PLUGIN_PACKAGE_NAME ffcontact)
set(CPACK_DEBIAN_PLUGIN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PLUGIN_DESCRIPTION "A plugin for FreeFEM that solves unilateral contact with Coulomb friction in
the plane and in space by mixed finite elements, judges the solution by an
admissible pair (error in the constitutive relation), and adapts meshes to a
wanted error. Scripts run with the command ffcontact-freefem.")
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/debian/dependencies.cmake)
set(CPACK_FFCONTACT_PLUGIN_DIR ${PROJECT_BINARY_DIR}/plugin)

set(debian ${PROJECT_BINARY_DIR}/debian)
configure_file(${CMAKE_CURRENT_LIST_DIR}/debian/changelog.txt ${debian}/changelog @ONLY)
execute_process(COMMAND gzip -9nf -k changelog WORKING_DIRECTORY ${debian})
install(FILES ${debian}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT plugin)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/debian/copyright.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT plugin RENAME copyright)
include(CPack)
