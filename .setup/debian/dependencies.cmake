# SPDX-License-Identifier: GPL-3.0-or-later
# Read by cpack. A plugin loads in the version of FreeFEM it was built for, and in no other; FreeFEM's own plugins and the files that
# scripts include (getARGV.idp) are in packages of their own. What only the module for several
# processes needs is recommended, as is gmsh: without them all else works.
set(plugin ${CPACK_FFCONTACT_PLUGIN_DIR})
set(work ${plugin}/dependencies)
file(MAKE_DIRECTORY ${work}/debian)
file(WRITE ${work}/debian/control "Source: ffcontact\nPackage: ffcontact\nArchitecture: any\n")
set(shared)
if(EXISTS ${plugin}/ffcontact_mpi.so)
  set(shared -dRecommends -e${plugin}/ffcontact_mpi.so)
endif()
execute_process(COMMAND dpkg-shlibdeps -O -e${plugin}/ffcontact.so -e${plugin}/ffcontact_solids.so ${shared}
  WORKING_DIRECTORY ${work} OUTPUT_VARIABLE libraries ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "shlibs:Depends=([^\n]*)" found "${libraries}")
set(depends ${CMAKE_MATCH_1})
set(recommends gmsh)
if(libraries MATCHES "shlibs:Recommends=([^\n]*)")
  string(APPEND recommends ", ${CMAKE_MATCH_1}")
endif()

execute_process(COMMAND dpkg-query -W -f "\${source:Upstream-Version}" freefem++ OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" version "${version}")
math(EXPR next "${CMAKE_MATCH_2} + 1")
set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS "freefem++ (>= ${version}), freefem++ (<< ${CMAKE_MATCH_1}.${next}~), \
libfreefem++, libfreefem++-dev, ${depends}")
set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS "${recommends}")
