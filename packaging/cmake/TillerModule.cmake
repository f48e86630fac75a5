# SPDX-License-Identifier: MIT
# Functions used by the CMakeLists.txt of every folder.

# The gold linker links the two hundred test programs in a quarter of the time of the default linker.
find_program(TILLER_GOLD ld.gold)
mark_as_advanced(TILLER_GOLD)
if(TILLER_GOLD AND NOT WIN32 AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT TILLER_SANITIZE)
    add_link_options(-fuse-ld=gold)
endif()

# Compiler options for all targets of this project. Warnings are errors: see
# packaging/reference/contributing.md.
add_library(tiller_options INTERFACE)
target_compile_features(tiller_options INTERFACE cxx_std_20)
target_include_directories(tiller_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_definitions(tiller_options INTERFACE QT_NO_KEYWORDS QT_NO_FOREACH)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The garbage collector of GCC scans the whole precompiled header. Running it less often saves a tenth of
    # the time.
    target_compile_options(tiller_options INTERFACE --param=ggc-min-expand=100 --param=ggc-min-heapsize=600000)
endif()
if(NOT MSVC)
    target_compile_options(tiller_options INTERFACE
        -Wall -Wextra -Wpedantic -Wconversion -Wshadow $<$<BOOL:${TILLER_WARNINGS_ARE_ERRORS}>:-Werror>)
else()
    target_compile_options(tiller_options INTERFACE /W4 /WX /permissive-)
endif()
if(TILLER_SANITIZE)
    target_compile_options(tiller_options INTERFACE
        -fsanitize=${TILLER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
        # With a sanitizer, GCC falsely reports uninitialized values in std::variant and std::optional.
        -Wno-maybe-uninitialized)
    target_link_options(tiller_options INTERFACE -fsanitize=${TILLER_SANITIZE})
endif()
if(TILLER_BUILD_FUZZERS)
    # AddressSanitizer also reports the errors found by the checks null and object-size, which take a tenth of the
    # compile time. In modules that use Eigen, these two and the alignment and vptr checks take half of it.
    target_compile_options(tiller_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined
        -fno-sanitize=null,object-size
        "$<$<IN_LIST:$<TARGET_PROPERTY:NAME>,tiller_arm;tiller_kinematics>:-fno-sanitize=alignment,vptr>")
    target_link_options(tiller_options INTERFACE -fsanitize=address,undefined)
endif()

# Most of the compile time is spent in the headers of Qt, Eigen and the standard library. They are precompiled
# once for each kind of target. A folder selects the kind with `set(TILLER_PRECOMPILED <kind>)`, the name of a
# header in packaging/cmake/precompiled.
option(TILLER_PRECOMPILE "Use precompiled headers (OFF detects missing includes)" ON)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Required by ccache for precompiled headers; packaging/prepare sets the other options.
    target_compile_options(tiller_options INTERFACE -fpch-preprocess)
endif()
function(tiller_precompile target)
    if(NOT TILLER_PRECOMPILE OR NOT TILLER_PRECOMPILED)
        return()
    endif()
    set(owner tiller_precompiled_${TILLER_PRECOMPILED})
    if(NOT TARGET ${owner})
        file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled/${TILLER_PRECOMPILED}.cpp CONTENT "// SPDX-License-Identifier: MIT\n")
        add_library(${owner} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${TILLER_PRECOMPILED}.cpp)
        set(modules Qt6::Core Eigen3::Eigen)
        if(TILLER_PRECOMPILED MATCHES "widgets")
            list(APPEND modules Qt6::Widgets)
        endif()
        if(TILLER_PRECOMPILED MATCHES "test")
            list(APPEND modules Qt6::Test Qt6::Network)
        endif()
        target_link_libraries(${owner} PRIVATE ${modules} tiller_options)
        target_precompile_headers(${owner} PRIVATE
            ${CMAKE_SOURCE_DIR}/packaging/cmake/precompiled/${TILLER_PRECOMPILED}.h)
    endif()
    target_precompile_headers(${target} REUSE_FROM ${owner})
    # Use the same code model as the owner, because a header precompiled with -fPIC cannot be used with -fPIE.
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${target} PRIVATE -fPIC)
endfunction()

# tiller_moc(<target> <sources...>)
# A faster replacement of AUTOMOC for libraries: each .cpp includes the moc output of its header (moc_x.cpp)
# or of itself (x.moc). moc processes only this file without its includes, because no class of this project is
# declared by an external macro. moc runs for every header with a .cpp, which takes 10 ms per header, so that
# a header with a new Q_OBJECT cannot be missed.
function(tiller_moc target)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/moc_${target})
    set(mocs "")
    file(MAKE_DIRECTORY ${folder})
    target_include_directories(${target} PRIVATE ${folder})
    foreach(source ${ARGN})
        if(NOT source MATCHES "\\.cpp$")
            continue()
        endif()
        cmake_path(ABSOLUTE_PATH source)
        cmake_path(GET source STEM stem)
        cmake_path(REPLACE_EXTENSION source LAST_ONLY .h OUTPUT_VARIABLE header)
        set(moc ${folder}/moc_${stem}.cpp)
        if(EXISTS ${header})
            add_custom_command(OUTPUT ${moc} COMMAND Qt6::moc --no-notes -o ${moc} ${header} DEPENDS ${header} VERBATIM)
            list(APPEND mocs ${moc})
        endif()
        file(STRINGS ${source} object REGEX "^ *Q_(OBJECT|GADGET|NAMESPACE)" LIMIT_COUNT 1)
        if(object)
            set(moc ${folder}/${stem}.moc)
            add_custom_command(OUTPUT ${moc} COMMAND Qt6::moc --no-notes -o ${moc} ${source} DEPENDS ${source} VERBATIM)
            list(APPEND mocs ${moc})
        endif()
    endforeach()
    # A separate target without library dependencies, so that moc does not wait for the linked libraries.
    if(mocs)
        add_custom_target(${target}_moc DEPENDS ${mocs})
        add_dependencies(${target} ${target}_moc)
    endif()
endfunction()

# tiller_module(NAME <module> SOURCES <files...> DEPENDS <targets...>)
# Adds the static library tiller_<module> with the alias tiller::<module>.
function(tiller_module)
    cmake_parse_arguments(ARG "" "NAME" "SOURCES;DEPENDS" ${ARGN})
    add_library(tiller_${ARG_NAME} STATIC ${ARG_SOURCES})
    add_library(tiller::${ARG_NAME} ALIAS tiller_${ARG_NAME})
    target_link_libraries(tiller_${ARG_NAME} PUBLIC ${ARG_DEPENDS} PRIVATE $<BUILD_INTERFACE:tiller_options>)
    target_include_directories(tiller_${ARG_NAME} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>)
    target_compile_features(tiller_${ARG_NAME} PUBLIC cxx_std_20)
    set_target_properties(tiller_${ARG_NAME} PROPERTIES EXPORT_NAME ${ARG_NAME})
    tiller_moc(tiller_${ARG_NAME} ${ARG_SOURCES})
    tiller_precompile(tiller_${ARG_NAME})
endfunction()

# tiller_test_surroundings(<name> <timeout s> [<variable=value>...])
# Sets the environment and the timeout of a Qt Test program in ctest; the timeout is longer with a sanitizer.
function(tiller_test_surroundings name timeout)
    if(TILLER_SANITIZE)
        math(EXPR timeout "${timeout} * 8")
    endif()
    # Timeout of Qt Test for one function [ms]. The default of five minutes is too short for a busy computer.
    set(function_timeout "QTEST_FUNCTION_TIMEOUT=${timeout}000;")
    set(support ${CMAKE_SOURCE_DIR}/tests/support)
    # Tests with a long timeout start first, so that the last minutes are not spent on a single test.
    math(EXPR cost "${timeout} / 10")
    set_tests_properties(${name} PROPERTIES TIMEOUT ${timeout} COST ${cost} PROCESSORS 4
        ENVIRONMENT "TILLER_TEST_DATA=${CMAKE_SOURCE_DIR}/tests/data;LC_ALL=C.UTF-8;QT_QPA_PLATFORM=offscreen;\
TSAN_OPTIONS=suppressions=${support}/tsan.supp die_after_fork=0;\
LSAN_OPTIONS=suppressions=${support}/lsan.supp;${function_timeout}${ARGN}")
endfunction()

# tiller_test_moc(<name> <sources...>)
# A replacement of AUTOMOC for test programs at a tenth of its cost, which saves minutes for two hundred
# programs: each .cpp named tst_* includes its own .moc, and listed headers with Q_OBJECT get a moc file.
function(tiller_test_moc name)
    target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
    foreach(source ${ARGN})
        cmake_path(ABSOLUTE_PATH source)
        cmake_path(GET source STEM stem)
        if(source MATCHES "/tst_[^/]*\\.cpp$")
            set(moc ${CMAKE_CURRENT_BINARY_DIR}/${stem}.moc)
        elseif(source MATCHES "\\.h$")
            set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
            file(STRINGS ${source} object REGEX "Q_OBJECT" LIMIT_COUNT 1)
            if(NOT object)
                continue()
            endif()
            set(moc ${CMAKE_CURRENT_BINARY_DIR}/${name}_moc_${stem}.cpp)
        else()
            continue()
        endif()
        qt_generate_moc(${source} ${moc} TARGET ${name})
        target_sources(${name} PRIVATE ${moc})
    endforeach()
endfunction()

# tiller_test(NAME <tst_x> SOURCES <files...> DEPENDS <targets...> [OFFSCREEN] [WAITS] [TIMEOUT s]
#             [COST s] [PARTS n])
# Adds a Qt Test program, run by ctest under the name <last folder>/<tst_x>.
# OFFSCREEN runs it on Qt's offscreen platform.
# ctest runs five jobs per processor. A test takes four jobs, or one job with WAITS, for tests that mostly
# wait for real time.
# COST is the measured run time [s]: tests with a high cost start first. The default is a tenth of the
# timeout.
# PARTS splits the functions and rows of the test into this number of parallel ctest tests.
function(tiller_test)
    cmake_parse_arguments(ARG "OFFSCREEN;WAITS" "NAME;TIMEOUT;COST;PARTS" "SOURCES;DEPENDS;LABELS" ${ARGN})
    add_executable(${ARG_NAME} ${ARG_SOURCES})
    target_link_libraries(${ARG_NAME} PRIVATE ${ARG_DEPENDS} Qt6::Test Qt6::Network tiller_options)
    tiller_precompile(${ARG_NAME})
    tiller_test_moc(${ARG_NAME} ${ARG_SOURCES})
    set_target_properties(${ARG_NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin/tests)
    file(RELATIVE_PATH folder ${CMAKE_SOURCE_DIR}/tests ${CMAKE_CURRENT_SOURCE_DIR})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 120)
    endif()
    set(names ${folder}/${ARG_NAME})
    if(ARG_PARTS)
        set(names "")
        foreach(part RANGE 1 ${ARG_PARTS})
            list(APPEND names ${folder}/${ARG_NAME}_${part}_of_${ARG_PARTS})
            add_test(NAME ${folder}/${ARG_NAME}_${part}_of_${ARG_PARTS}
                COMMAND tiller_test_part ${part} ${ARG_PARTS} $<TARGET_FILE:${ARG_NAME}>)
        endforeach()
    else()
        add_test(NAME ${folder}/${ARG_NAME} COMMAND ${ARG_NAME})
    endif()
    foreach(name ${names})
        tiller_test_surroundings(${name} ${ARG_TIMEOUT})
        set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}")
        if(ARG_COST)
            set_tests_properties(${name} PROPERTIES COST ${ARG_COST})
        endif()
        if(ARG_WAITS)
            set_tests_properties(${name} PROPERTIES PROCESSORS 1)
        endif()
    endforeach()
endfunction()
