# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(ffcontact) brings ffcontact::core. The library is static, so what it links is needed too.
include(CMakeFindDependencyMacro)
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(CHOLMOD)
find_dependency(KLU)
find_dependency(OpenMP COMPONENTS CXX)
list(POP_FRONT CMAKE_MODULE_PATH)
include(${CMAKE_CURRENT_LIST_DIR}/ffcontactTargets.cmake)
