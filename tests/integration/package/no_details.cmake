# SPDX-License-Identifier: MIT
# Run by ctest: no private header has been installed, and others have.
file(GLOB_RECURSE headers ${PREFIX}/include/*.h)
list(LENGTH headers count)
if(count LESS 50)
    message(FATAL_ERROR "only ${count} headers under ${PREFIX}/include")
endif()
# What a room keeps to itself, and the rooms of the simulated controller but its few public headers.
list(FILTER headers INCLUDE REGEX "/detail/|/custom/|/simulator/(programs|host|servers|equipment|urscript)/")
if(headers)
    message(FATAL_ERROR "installed: ${headers}")
endif()
