# SPDX-License-Identifier: MIT
# Run by ctest. Only public headers must be installed.
file(GLOB_RECURSE headers ${PREFIX}/include/*.h)
list(LENGTH headers count)
if(count LESS 50)
    message(FATAL_ERROR "only ${count} headers under ${PREFIX}/include")
endif()
# Private folders of the modules, and all headers of the simulated controller except the few public ones.
list(FILTER headers INCLUDE REGEX "/detail/|/custom/|/simulator/(programs|host|servers|equipment|urscript)/")
if(headers)
    message(FATAL_ERROR "installed: ${headers}")
endif()
