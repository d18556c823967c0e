# One library per folder, explicit sources, explicit dependencies; one test program per folder.

add_library(tdbd_flags INTERFACE)
target_compile_features(tdbd_flags INTERFACE cxx_std_20)
target_include_directories(tdbd_flags INTERFACE "${PROJECT_SOURCE_DIR}/src")
# Contraction off: the same bytes with and without fused multiply-add (design: determinism).
target_compile_options(tdbd_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -ffp-contract=off -fno-fast-math)
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g -D_GLIBCXX_ASSERTIONS -DTDBD_CHECK_EVERY_OPERATION")
set(CMAKE_CXX_EXTENSIONS OFF)

find_program(TDBD_CCACHE ccache)
if(TDBD_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${TDBD_CCACHE}")
endif()

# tdbd_library(NAME SOURCES a.cpp ... LINKS dep ...): links are public.
function(tdbd_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC tdbd_flags ${ARG_LINKS})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE tdbd_flags ${ARG_LINKS})
  endif()
endfunction()

# All programs that scripts/report needs.
add_custom_target(report_programs)

# tdbd_tests(NAME SOURCES a_test.cpp ... LINKS dep ...): one GoogleTest program, one ctest entry per test.
# Tests that link tdbd_evidence have the label evidence: scripts/report builds and runs them.
function(tdbd_tests name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/verification" "${PROJECT_SOURCE_DIR}")
  target_compile_definitions(${name} PRIVATE TDBD_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest_main rapidcheck rapidcheck_gtest)
  set(labels "")
  if("tdbd_evidence" IN_LIST ARG_LINKS)
    set(labels LABELS evidence)
    add_dependencies(report_programs ${name})
  endif()
  gtest_discover_tests(${name} PROPERTIES TIMEOUT 600 ${labels} DISCOVERY_TIMEOUT 60)
endfunction()
