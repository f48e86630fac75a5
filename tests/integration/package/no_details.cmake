# SPDX-License-Identifier: MIT
# Run by ctest: no header under a detail/ folder has been installed, and others have.
file(GLOB_RECURSE headers ${PREFIX}/include/*.h)
list(LENGTH headers count)
if(count LESS 50)
    message(FATAL_ERROR "only ${count} headers under ${PREFIX}/include")
endif()
list(FILTER headers INCLUDE REGEX "/detail/")
if(headers)
    message(FATAL_ERROR "installed: ${headers}")
endif()
