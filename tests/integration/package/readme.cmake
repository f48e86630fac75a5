# SPDX-License-Identifier: MIT
# Run by ctest. Builds the CMakeLists.txt and the program of the README, exactly as printed, in a separate
# folder.
file(READ ${TOP}/robot/README.md page)
if(NOT page MATCHES "```cmake\n([^`]*)```")
    message(FATAL_ERROR "robot/README.md shows no CMakeLists.txt")
endif()
file(REMOVE_RECURSE ${FOLDER})
file(WRITE ${FOLDER}/CMakeLists.txt "${CMAKE_MATCH_1}")
file(COPY ${TOP}/robot/examples/cpp/move_and_wait.cpp DESTINATION ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER} -B ${FOLDER}/build ${OPTIONS} -Werror=dev
    COMMAND_ERROR_IS_FATAL ANY ERROR_VARIABLE warnings)
if(warnings)
    message(FATAL_ERROR "${warnings}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build COMMAND_ERROR_IS_FATAL ANY)
