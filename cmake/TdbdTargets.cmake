# One library per folder, explicit sources, explicit dependencies; one test program per folder.

add_library(tdbd_flags INTERFACE)
target_compile_features(tdbd_flags INTERFACE cxx_std_20)
target_include_directories(tdbd_flags INTERFACE "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>")
# Contraction off: results are bitwise identical with and without fused multiply-add (design: determinism).
# Code that uses the installed headers needs this option too; the warnings apply only to this build.
target_compile_options(tdbd_flags INTERFACE
  "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Werror>" -ffp-contract=off -fno-fast-math)
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g -D_GLIBCXX_ASSERTIONS -DTDBD_CHECK_EVERY_OPERATION")
set(CMAKE_CXX_EXTENSIONS OFF)
# Tests and twins are compiled quickly. Results have the same bits at every level: contraction is off.
# At -O1 g++ 12 warns of variables that it does not follow.
set(TDBD_ONLY_TESTED "$<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>")

find_program(TDBD_CCACHE ccache)
if(TDBD_CCACHE)
  # These two let it keep objects that were made with a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      "${TDBD_CCACHE}")
endif()

# The modules go into the program and into the Python module, a shared library: code that may lie anywhere. Names stay
# inside, so that a call from module to module costs no more than in a program.
function(tdbd_shareable name)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# What most sources include, read once. Through a precompiled header g++ 12 warns of std::string's own code (its bug
# 105651 and kin): those four warnings are left to the preset strict, which has none.
option(TDBD_PRECOMPILED "Precompile what most sources include" ON)
set(TDBD_PRECOMPILED_OPTIONS -fpch-preprocess -Wno-array-bounds -Wno-stringop-overflow
  -Wno-stringop-overread -Wno-restrict)
function(tdbd_precompiled name)
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp" "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  cmake_parse_arguments(ARG "" "" "HEADERS;LINKS" ${ARGN})
  target_link_libraries(${name} PRIVATE tdbd_flags tdbd_eigen ${ARG_LINKS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
  target_compile_options(${name} PRIVATE -fpch-preprocess)
endfunction()

# The sources of a folder are compiled together: headers are read once for all of them, and a changed source costs its
# folder. So no two of them may use one name for two things in their unnamed namespaces. Off: one object a source.
option(TDBD_UNITY "Compile the sources of a folder together" ON)
option(TDBD_SRC_APART "Compile every source of src by itself, so that its object can be exchanged (scripts/mutate)" OFF)
function(tdbd_by_folder name)
  set(src "${PROJECT_SOURCE_DIR}/src")
  cmake_path(IS_PREFIX src "${CMAKE_CURRENT_SOURCE_DIR}" of_src)
  if(NOT TDBD_UNITY OR (TDBD_SRC_APART AND of_src))
    return()
  endif()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${name}_${folder}" group)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
  endforeach()
endfunction()

# tdbd_library(NAME SOURCES a.cpp ... LINKS dep ... [OWN_FLAGS]): links are public. OWN_FLAGS: no precompiled header,
# since the library has flags of its own, or no Eigen.
function(tdbd_library name)
  cmake_parse_arguments(ARG "OWN_FLAGS" "" "SOURCES;LINKS" ${ARGN})
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC tdbd_flags ${ARG_LINKS})
    tdbd_shareable(${name})
    tdbd_by_folder(${name} ${ARG_SOURCES})
    if(TDBD_PRECOMPILED AND TARGET tdbd_headers AND NOT ARG_OWN_FLAGS)
      target_precompile_headers(${name} REUSE_FROM tdbd_headers)
      target_compile_options(${name} PRIVATE ${TDBD_PRECOMPILED_OPTIONS})
    endif()
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE tdbd_flags ${ARG_LINKS})
  endif()
endfunction()

# What tests include: reading it takes longer than compiling most of them.
option(TDBD_OBSERVE "Let checks of tests note how much of their tolerance they use up (scripts/tolerances)" OFF)
function(tdbd_test_headers)
  set(observe "$<$<BOOL:${TDBD_OBSERVE}>:${PROJECT_SOURCE_DIR}/verification/tolerance/observe.hpp>")
  tdbd_precompiled(tdbd_test_headers LINKS GTest::gtest rapidcheck rapidcheck_gtest
    HEADERS <gtest/gtest.h> <rapidcheck.h> <rapidcheck/gtest.h> <Eigen/Dense> <filesystem> <fstream> <string> <vector>
            ${observe})
endfunction()

# All programs that scripts/report needs.
add_custom_target(report_programs)

# tdbd_tests(NAME SOURCES a_test.cpp ... LINKS dep ... [TOGETHER Suite ...]): one GoogleTest program, one ctest
# entry per test; one for the whole of a suite that shares a long run.
# Tests that link tdbd_evidence have the label evidence: scripts/report builds and runs them.
set(TDBD_TEST_TIMEOUT 600 CACHE STRING "s, after which a test of the programs is stopped")
function(tdbd_tests name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;TOGETHER" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/verification" "${PROJECT_SOURCE_DIR}")
  target_compile_definitions(${name} PRIVATE TDBD_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE tdbd_eigen ${ARG_LINKS} GTest::gtest_main rapidcheck rapidcheck_gtest)
  target_precompile_headers(${name} REUSE_FROM tdbd_test_headers)
  tdbd_by_folder(${name} ${ARG_SOURCES})
  target_compile_options(${name} PRIVATE ${TDBD_PRECOMPILED_OPTIONS} "$<$<BOOL:${TDBD_OBSERVE}>:-Wno-parentheses;-Wdangling-else>")
  set(labels "")
  if("tdbd_evidence" IN_LIST ARG_LINKS)
    set(labels LABELS evidence)
    add_dependencies(report_programs ${name})
  endif()
  set(apart "")
  foreach(suite IN LISTS ARG_TOGETHER)
    string(APPEND apart ":${suite}.*")
    add_test(NAME ${suite} COMMAND ${name} --gtest_filter=${suite}.*)
    set_tests_properties(${suite} PROPERTIES TIMEOUT ${TDBD_TEST_TIMEOUT} FAIL_REGULAR_EXPRESSION "Running 0 tests" ${labels})
  endforeach()
  string(REGEX REPLACE "^:" "TEST_FILTER;-" apart "${apart}")
  gtest_discover_tests(${name} ${apart} PROPERTIES TIMEOUT ${TDBD_TEST_TIMEOUT} ${labels} DISCOVERY_TIMEOUT 60)
endfunction()
