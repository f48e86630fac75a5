# SPDX-License-Identifier: MIT
# What other projects get: find_package(tiller) with tiller::robot (the backend), tiller::simulator and tiller::ur_rtde.
# `cmake --install BUILD --component development` puts it in place.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(tiller_rooms core realtime rtde receive script dashboard control io kinematics program recording doctor)
add_library(tiller_robot INTERFACE)
add_library(tiller::robot ALIAS tiller_robot)
set_target_properties(tiller_robot PROPERTIES EXPORT_NAME robot)
list(TRANSFORM tiller_rooms PREPEND tiller:: OUTPUT_VARIABLE tiller_room_targets)
target_link_libraries(tiller_robot INTERFACE ${tiller_room_targets})

list(TRANSFORM tiller_rooms PREPEND tiller_ OUTPUT_VARIABLE tiller_room_libraries)
install(TARGETS tiller_robot ${tiller_room_libraries} tiller_simulator tiller_urscript tiller_arm tiller_ur_rtde
    EXPORT tillerTargets COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/tiller
    INCLUDES DESTINATION include/tiller)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/robot/ DESTINATION include/tiller/robot COMPONENT development
    FILES_MATCHING PATTERN "*.h" PATTERN "python" EXCLUDE)
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
