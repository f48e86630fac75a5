# SPDX-License-Identifier: MIT
# Run by ctest: the folder of examples, copied out of the tree, is a project of its own.
file(REMOVE_RECURSE ${FOLDER})
file(COPY ${TOP}/robot/examples/cpp DESTINATION ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER}/cpp -B ${FOLDER}/build ${OPTIONS} COMMAND_ERROR_IS_FATAL ANY)
# One is compiled; the suite compiles all of them with the library.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build --target example_simulate COMMAND_ERROR_IS_FATAL ANY)
