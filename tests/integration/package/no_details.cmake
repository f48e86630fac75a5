# SPDX-License-Identifier: MIT
# Run by ctest: private headers are not installed, public ones are.
file(GLOB_RECURSE headers ${PREFIX}/include/*.h)
list(LENGTH headers count)
if(count LESS 50)
    message(FATAL_ERROR "only ${count} headers under ${PREFIX}/include")
endif()
# Private folders of the modules, and all but the few public headers of the simulated controller.
list(FILTER headers INCLUDE REGEX "/detail/|/custom/|/simulator/(programs|host|servers|equipment|urscript)/")
if(headers)
    message(FATAL_ERROR "installed: ${headers}")
endif()
