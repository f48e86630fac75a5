# SPDX-License-Identifier: MIT
# What other projects get: find_package(tiller) with tiller::robot (the backend), tiller::simulator and tiller::ur_rtde.
# `cmake --install BUILD --component development` puts it in place.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# What programs written for ur_rtde include; the rest of that room is not theirs.
set(ur_rtde_headers async_operation_status.h dashboard_client.h dashboard_enums.h robot_state.h robotiq_gripper.h
    rtde.h rtde_control_interface.h rtde_export.h rtde_io_interface.h rtde_path.h rtde_receive_interface.h
    rtde_utility.h script_client.h)

# Of the simulated controller, what starts one in a process and steps it.
set(simulator_headers assumptions.h simulator.h simulator_options.h arm/arm_state.h arm/environment.h box/personality.h)

set(tiller_rooms core realtime rtde receive script dashboard control io kinematics collision project recording doctor)
add_library(tiller_robot INTERFACE)
add_library(tiller::robot ALIAS tiller_robot)
set_target_properties(tiller_robot PROPERTIES EXPORT_NAME robot)
list(TRANSFORM tiller_rooms PREPEND tiller:: OUTPUT_VARIABLE tiller_room_targets)
target_link_libraries(tiller_robot INTERFACE ${tiller_room_targets})

# For programs written for ur_rtde that are built without CMake: #include <ur_rtde/...> and -lrtde.
add_library(ur_rtde_library SHARED $<TARGET_OBJECTS:tiller_ur_rtde>)
set_target_properties(ur_rtde_library PROPERTIES OUTPUT_NAME rtde LINKER_LANGUAGE CXX
    UR_RTDE_HEADERS "${ur_rtde_headers}"
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_link_libraries(ur_rtde_library PRIVATE tiller::ur_rtde)
list(TRANSFORM ur_rtde_headers PREPEND ${CMAKE_SOURCE_DIR}/robot/ur_rtde/ OUTPUT_VARIABLE ur_rtde_files)
install(FILES ${ur_rtde_files} DESTINATION include/ur_rtde COMPONENT development)

if(TILLER_SHARED)
    include(TillerShared)
    install(TARGETS ur_rtde_library EXPORT tillerTargets COMPONENT development INCLUDES DESTINATION include/tiller)
else()
    install(TARGETS ur_rtde_library COMPONENT development)
    list(TRANSFORM tiller_rooms PREPEND tiller_ OUTPUT_VARIABLE tiller_room_libraries)
    install(TARGETS tiller_robot ${tiller_room_libraries} tiller_simulator tiller_urscript tiller_arm tiller_ur_rtde
        EXPORT tillerTargets COMPONENT development
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/tiller
        INCLUDES DESTINATION include/tiller)
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/robot/ DESTINATION include/tiller/robot COMPONENT development
    FILES_MATCHING PATTERN "*.h" PATTERN "python" EXCLUDE PATTERN "detail" EXCLUDE PATTERN "examples" EXCLUDE
    PATTERN "simulator" EXCLUDE PATTERN "ur_rtde" EXCLUDE
    # Those need more libraries than the backend has; they are the application's for now.
    PATTERN "mcap" EXCLUDE PATTERN "hdf5" EXCLUDE PATTERN "formats" EXCLUDE PATTERN "live" EXCLUDE
    PATTERN "divergence" EXCLUDE
    # Internal to the programs for now.
    PATTERN "station" EXCLUDE)
foreach(room ur_rtde simulator)
    foreach(header ${${room}_headers})
        cmake_path(GET header PARENT_PATH folder)
        install(FILES ${CMAKE_SOURCE_DIR}/robot/${room}/${header} DESTINATION include/tiller/robot/${room}/${folder}
            COMPONENT development)
    endforeach()
endforeach()
install(EXPORT tillerTargets NAMESPACE tiller:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tiller
    COMPONENT development)
configure_package_config_file(${CMAKE_SOURCE_DIR}/packaging/cmake/tillerConfig.cmake.in
    ${CMAKE_BINARY_DIR}/tillerConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tiller)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/tillerConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/tillerConfig.cmake ${CMAKE_BINARY_DIR}/tillerConfigVersion.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tiller COMPONENT development)
# Of the ur_rtde that the interface is.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/ur_rtdeConfigVersion.cmake VERSION 1.5.8
    COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_SOURCE_DIR}/packaging/cmake/ur_rtdeConfig.cmake ${CMAKE_BINARY_DIR}/ur_rtdeConfigVersion.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ur_rtde COMPONENT development)
