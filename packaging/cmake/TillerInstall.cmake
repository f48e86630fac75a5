# SPDX-License-Identifier: MIT
# Installed files for other projects: find_package(tiller) with tiller::robot (the backend), tiller::simulator
# and tiller::ur_rtde. Install them with `cmake --install BUILD --component development`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Headers that programs written for ur_rtde include. The other headers of that folder are private.
set(ur_rtde_headers async_operation_status.h dashboard_client.h dashboard_enums.h robot_state.h robotiq_gripper.h
    rtde.h rtde_control_interface.h rtde_export.h rtde_io_interface.h rtde_path.h rtde_receive_interface.h
    rtde_utility.h script_client.h)

# Public headers of the simulated controller, for starting and stepping a controller in a process.
set(simulator_headers simulator.h options/assumptions.h options/simulator_options.h arm/arm_state.h arm/environment.h
    plant/personality.h)

set(tiller_rooms platform core realtime rtde receive publish script dashboard control io kinematics collision project recording doctor api)
# Components that need more packages than the backend. Each has a separate export, which tillerConfig.cmake
# loads if the component is requested and its packages are installed.
set(tiller_extras recording_mcap recording_hdf5 recording_formats live)
# Modules needed to start the simulated arm or controller.
set(tiller_simulating simulator_options urscript pendant arm simulator_net simulator_plant simulator_equipment simulator_host
    simulator_programs simulator_controller simulator_servers simulator testing divergence)
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
    list(TRANSFORM tiller_simulating PREPEND tiller_ OUTPUT_VARIABLE tiller_simulating_libraries)
    install(TARGETS tiller_robot ${tiller_room_libraries} ${tiller_simulating_libraries} tiller_ur_rtde
        EXPORT tillerTargets COMPONENT development
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/tiller
        INCLUDES DESTINATION include/tiller)
    foreach(extra ${tiller_extras})
        install(TARGETS tiller_${extra} EXPORT tiller_${extra} COMPONENT development
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/tiller INCLUDES DESTINATION include/tiller)
        install(EXPORT tiller_${extra} NAMESPACE tiller:: FILE tillerTargets_${extra}.cmake
            DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tiller COMPONENT development)
    endforeach()
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/robot/ DESTINATION include/tiller/robot COMPONENT development
    FILES_MATCHING PATTERN "*.h" PATTERN "python" EXCLUDE PATTERN "detail" EXCLUDE PATTERN "examples" EXCLUDE
    PATTERN "simulator" EXCLUDE PATTERN "ur_rtde" EXCLUDE
    # These modules are private to the programs.
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
# The packages that the components of this build need.
if(TILLER_WITH_HDF5)
    set(TILLER_HDF5 TillerHdf5::hdf5)
    set(tiller_hdf5_package hdf5)
endif()
if(TILLER_WITH_WEBSOCKETS)
    set(TILLER_WEBSOCKETS Qt6::WebSockets)
    set(tiller_websockets_package Qt6WebSockets)
endif()
configure_package_config_file(${CMAKE_SOURCE_DIR}/packaging/cmake/tillerConfig.cmake.in
    ${CMAKE_BINARY_DIR}/tillerConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tiller)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/tillerConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/tillerConfig.cmake ${CMAKE_BINARY_DIR}/tillerConfigVersion.cmake
    ${CMAKE_SOURCE_DIR}/packaging/cmake/TillerHdf5.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tiller COMPONENT development)
# The version of the ur_rtde interface.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/ur_rtdeConfigVersion.cmake VERSION 1.5.8
    COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_SOURCE_DIR}/packaging/cmake/ur_rtdeConfig.cmake ${CMAKE_BINARY_DIR}/ur_rtdeConfigVersion.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ur_rtde COMPONENT development)

# The C interface. Its package does not search for Qt and Eigen, which only programs in C++ need.
set(tiller_c_package ${CMAKE_INSTALL_LIBDIR}/cmake/tiller_c)
install(EXPORT tiller_c NAMESPACE tiller:: FILE tiller_cConfig.cmake DESTINATION ${tiller_c_package} COMPONENT development)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/tiller_cConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/tiller_cConfigVersion.cmake DESTINATION ${tiller_c_package} COMPONENT development)

# For projects built without CMake: pkg-config --cflags --libs tiller tiller-simulator
file(RELATIVE_PATH tiller_pc_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
cmake_path(SET tiller_pc_prefix NORMALIZE "${tiller_pc_prefix}")

# tiller_pkg_config(<name> DESCRIPTION <text> ARCHIVES <folders...> REQUIRES <packages...>
#                   LIBRARIES <flags...>)
# ARCHIVES are in link order: dependent archives before their dependencies. If libtiller is installed, it
# replaces all of them.
function(tiller_pkg_config name)
    cmake_parse_arguments(ARG "" "DESCRIPTION" "ARCHIVES;REQUIRES;LIBRARIES" ${ARGN})
    if(TILLER_SHARED)
        set(ARG_LIBRARIES "")
        if(name STREQUAL "tiller")
            set(ARG_LIBRARIES -ltiller)
        else()
            set(ARG_REQUIRES tiller)
        endif()
        set(folder "")
    else()
        list(TRANSFORM ARG_ARCHIVES PREPEND -ltiller_)
        list(PREPEND ARG_LIBRARIES ${ARG_ARCHIVES})
        set(folder /tiller)
    endif()
    list(JOIN ARG_REQUIRES " " requires)
    list(JOIN ARG_LIBRARIES " " libraries)
    set(description "${ARG_DESCRIPTION}")
    configure_file(${CMAKE_SOURCE_DIR}/packaging/cmake/tiller.pc.in ${CMAKE_BINARY_DIR}/pkgconfig/${name}.pc @ONLY)
    install(FILES ${CMAKE_BINARY_DIR}/pkgconfig/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
endfunction()
configure_file(${CMAKE_SOURCE_DIR}/packaging/cmake/tiller-c.pc.in ${CMAKE_BINARY_DIR}/pkgconfig/tiller-c.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/pkgconfig/tiller-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
set(tiller_link_order ${tiller_rooms})
list(REVERSE tiller_link_order)
tiller_pkg_config(tiller DESCRIPTION "Watches and moves Universal Robots arms" ARCHIVES ${tiller_link_order}
    REQUIRES Qt6Network Qt6Core eigen3 LIBRARIES -pthread)
tiller_pkg_config(tiller-simulator DESCRIPTION "Simulated Universal Robots controller, and comparison of recordings with it"
    ARCHIVES testing divergence simulator simulator_servers simulator_controller simulator_programs simulator_host
        simulator_equipment simulator_plant simulator_net pendant arm urscript simulator_options REQUIRES tiller zlib LIBRARIES -lorocos-kdl)
tiller_pkg_config(tiller-recording-mcap DESCRIPTION "Recordings in MCAP" ARCHIVES recording_mcap
    REQUIRES tiller zlib libzstd LIBRARIES -lfastcdr)
tiller_pkg_config(tiller-recording-formats DESCRIPTION "Recordings in CSV, MCAP and HDF5"
    ARCHIVES recording_formats recording_hdf5 REQUIRES tiller-recording-mcap ${tiller_hdf5_package})
tiller_pkg_config(tiller-live DESCRIPTION "Live data for Foxglove and PlotJuggler" ARCHIVES live
    REQUIRES tiller-recording-mcap ${tiller_websockets_package})
