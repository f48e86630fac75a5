# SPDX-License-Identifier: MIT
# Run by ctest. A package required by a component is missing. The other components must be found, and the
# message must contain the names of the component and the package.
file(REMOVE_RECURSE ${FOLDER})
set(hidden -DCMAKE_DISABLE_FIND_PACKAGE_fastcdr=ON)
file(WRITE ${FOLDER}/other/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(other LANGUAGES CXX)
find_package(tiller 0.1 REQUIRED COMPONENTS robot recording_hdf5)
find_package(tiller 0.1 REQUIRED)
if(TARGET tiller::recording_mcap)
    message(FATAL_ERROR \"found without fastcdr\")
endif()
")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER}/other -B ${FOLDER}/other/build ${OPTIONS} ${hidden}
    COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${FOLDER}/asked/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(asked LANGUAGES CXX)
find_package(tiller 0.1 REQUIRED COMPONENTS recording_formats)
")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER}/asked -B ${FOLDER}/asked/build ${OPTIONS} ${hidden}
    RESULT_VARIABLE result ERROR_VARIABLE text OUTPUT_QUIET)
string(REGEX REPLACE "[ \n]+" " " text "${text}")
if(result EQUAL 0 OR NOT text MATCHES "\"recording_mcap\" needs fastcdr \\(on Debian: libfastcdr-dev")
    message(FATAL_ERROR "${result}: ${text}")
endif()
