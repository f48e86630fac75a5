# SPDX-License-Identifier: MIT
# For projects written for ur_rtde: find_package(ur_rtde) and the target ur_rtde::rtde use Tiller's
# implementation of this interface.
include(CMakeFindDependencyMacro)
find_dependency(tiller HINTS "${CMAKE_CURRENT_LIST_DIR}/../tiller")
if(NOT TARGET ur_rtde::rtde)
    add_library(ur_rtde::rtde INTERFACE IMPORTED)
    set_target_properties(ur_rtde::rtde PROPERTIES INTERFACE_LINK_LIBRARIES tiller::ur_rtde)
endif()
