# SPDX-License-Identifier: MIT
# Run by ctest. A copy of the examples folder outside the source tree must be a complete project.
file(REMOVE_RECURSE ${FOLDER})
file(COPY ${TOP}/robot/examples/cpp DESTINATION ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER}/cpp -B ${FOLDER}/build ${OPTIONS} COMMAND_ERROR_IS_FATAL ANY)
# Only one example is compiled here. The suite compiles all of them with the library.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build --target example_simulate COMMAND_ERROR_IS_FATAL ANY)
