# SPDX-License-Identifier: MIT
# One shared library (libtiller) with all modules and the simulated controller, for distributions. It exports
# exactly the declarations of the installed headers and is installed instead of the archives of the modules;
# find_package(tiller) defines the same targets.
#
# ABI rule: increase TILLER_ABI whenever an exported symbol of a released version is removed or changed, but
# not for additions.
set(TILLER_ABI 1)

set(tiller_objects)
foreach(room ${tiller_rooms} ${tiller_simulating} ${tiller_extras})
    list(APPEND tiller_objects $<TARGET_OBJECTS:tiller_${room}>)
    list(APPEND tiller_archives $<TARGET_FILE:tiller_${room}>)
    list(APPEND tiller_archive_targets tiller_${room})
endforeach()
foreach(header ${simulator_headers})
    list(APPEND simulator_header_files robot/simulator/${header})
endforeach()

# tiller_exports(<target> <headers...> ARCHIVES <files...> DEPENDS <targets...>)
# Limits the exported symbols of the target to the declarations of these headers.
function(tiller_exports target)
    cmake_parse_arguments(ARG "" "" "ARCHIVES;DEPENDS" ${ARGN})
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}.exports)
    add_custom_command(OUTPUT ${list}
        COMMAND ${Python_EXECUTABLE} -B ${CMAKE_SOURCE_DIR}/packaging/cmake/list_exports.py --nm ${CMAKE_NM}
                --top ${CMAKE_SOURCE_DIR} --output ${list} --headers ${ARG_UNPARSED_ARGUMENTS} --archives ${ARG_ARCHIVES}
        DEPENDS ${ARG_DEPENDS} ${CMAKE_SOURCE_DIR}/packaging/cmake/list_exports.py
        COMMENT "Listing what ${target} exports" VERBATIM)
    add_custom_target(${target}_exports DEPENDS ${list})
    add_dependencies(${target} ${target}_exports)
    target_link_options(${target} PRIVATE -Wl,--version-script=${list} -Wl,--no-undefined)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${list})
endfunction()

add_library(tiller_shared SHARED ${tiller_objects})
set_target_properties(tiller_shared PROPERTIES OUTPUT_NAME tiller EXPORT_NAME tiller LINKER_LANGUAGE CXX
    VERSION ${TILLER_ABI}.${PROJECT_VERSION} SOVERSION ${TILLER_ABI})
# The objects of the archives are already included. This adds their external dependencies.
target_link_libraries(tiller_shared PUBLIC Qt6::Core Qt6::Network Eigen3::Eigen Threads::Threads PRIVATE
    ${tiller_archive_targets})
target_include_directories(tiller_shared PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>)
target_compile_features(tiller_shared PUBLIC cxx_std_20)
target_compile_definitions(tiller_shared INTERFACE $<INSTALL_INTERFACE:${TILLER_WITHOUT_QT_KEYWORDS}>)
tiller_exports(tiller_shared robot/platform robot/core robot/realtime robot/rtde robot/receive robot/publish robot/script robot/dashboard robot/control
    robot/io robot/kinematics robot/collision robot/project robot/recording robot/doctor robot/api robot/live robot/divergence robot/testing
    ${simulator_header_files}
    ARCHIVES ${tiller_archives} DEPENDS ${tiller_archive_targets})

# The ur_rtde library uses libtiller, like any other program.
set_property(TARGET ur_rtde_library PROPERTY LINK_LIBRARIES)
target_link_libraries(ur_rtde_library PUBLIC tiller_shared)
target_include_directories(ur_rtde_library PUBLIC $<INSTALL_INTERFACE:include/tiller/robot>)
list(TRANSFORM ur_rtde_headers PREPEND robot/ur_rtde/ OUTPUT_VARIABLE ur_rtde_exported)
tiller_exports(ur_rtde_library ${ur_rtde_exported} ARCHIVES $<TARGET_FILE:tiller_ur_rtde> DEPENDS tiller_ur_rtde)
set_target_properties(ur_rtde_library PROPERTIES EXPORT_NAME ur_rtde)

# The target names used by programs: tiller::control, tiller::robot ...
set(tiller_names robot ${tiller_rooms} ${tiller_extras} testing divergence simulator)
foreach(name ${tiller_names})
    add_library(tiller_name_${name} INTERFACE)
    set_target_properties(tiller_name_${name} PROPERTIES EXPORT_NAME ${name})
    target_link_libraries(tiller_name_${name} INTERFACE tiller_shared)
    list(APPEND tiller_name_targets tiller_name_${name})
endforeach()
install(TARGETS tiller_shared ${tiller_name_targets} EXPORT tillerTargets COMPONENT development
    INCLUDES DESTINATION include/tiller)
