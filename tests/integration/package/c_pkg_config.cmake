# SPDX-License-Identifier: MIT
# Run by ctest. Builds a program in C with the flags from pkg-config and runs it.
set(ENV{PKG_CONFIG_PATH} ${LIBRARIES}/pkgconfig)
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs tiller-c OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${COMPILER} -std=c99 ${CMAKE_CURRENT_LIST_DIR}/c/installed_c.c -o ${FOLDER}/c_pkg_config ${flags}
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${LIBRARIES} ${FOLDER}/c_pkg_config
    COMMAND_ERROR_IS_FATAL ANY)
