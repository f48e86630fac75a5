# SPDX-License-Identifier: MIT
# Run by ctest. Builds a program with the flags from pkg-config and runs it.
set(ENV{PKG_CONFIG_PATH} ${LIBRARIES}/pkgconfig)
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs tiller-simulator tiller-recording-formats tiller-live
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${COMPILER} -std=c++20 -fPIC ${CMAKE_CURRENT_LIST_DIR}/components/components.cpp
    -o ${FOLDER}/pkg_config_program ${flags} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${LIBRARIES} ${FOLDER}/pkg_config_program
    COMMAND_ERROR_IS_FATAL ANY)
# A program that uses only the backend must not need the packages of other components.
execute_process(COMMAND ${PKG_CONFIG} --libs tiller OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
if(flags MATCHES "zstd|hdf5|fastcdr|WebSockets")
    message(FATAL_ERROR "tiller.pc: ${flags}")
endif()
