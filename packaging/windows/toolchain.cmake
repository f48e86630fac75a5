# SPDX-License-Identifier: MIT
# MinGW-w64 of Debian (GCC with POSIX threads). TILLER_WINDOWS_PREFIX: folder of the libraries that
# packaging/windows/cross has built.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
if(NOT TILLER_WINDOWS_PREFIX)
    set(TILLER_WINDOWS_PREFIX $ENV{TILLER_WINDOWS_PREFIX})
endif()
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TILLER_WINDOWS_PREFIX)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 ${TILLER_WINDOWS_PREFIX})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CROSSCOMPILING_EMULATOR /usr/bin/wine)
# Eigen consists of architecture-independent headers. Use those of Debian, which are outside the root path.
set(Eigen3_DIR /usr/share/eigen3/cmake)
