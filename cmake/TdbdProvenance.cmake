# Version, commit and flags, compiled into one small file that changes when the commit changes.

find_package(Git QUIET)
set(TDBD_COMMIT "unknown")
# `git archive` replaces the text between the dollars of commit.txt (.gitattributes).
file(STRINGS "${PROJECT_SOURCE_DIR}/cmake/commit.txt" archived REGEX "^[0-9a-f]+$")
if(archived)
  string(SUBSTRING "${archived}" 0 12 TDBD_COMMIT)
elseif(Git_FOUND AND EXISTS "${PROJECT_SOURCE_DIR}/.git")
  execute_process(COMMAND "${GIT_EXECUTABLE}" -C "${PROJECT_SOURCE_DIR}" describe --always --dirty --abbrev=12 "--exclude=*"
                  OUTPUT_VARIABLE TDBD_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/.git/HEAD")
endif()
string(TOUPPER "${CMAKE_BUILD_TYPE}" TDBD_BUILD_TYPE_UPPER)
set(TDBD_FLAGS "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${TDBD_BUILD_TYPE_UPPER}} -ffp-contract=off")
string(STRIP "${TDBD_FLAGS}" TDBD_FLAGS)
configure_file("${PROJECT_SOURCE_DIR}/src/core/provenance.cpp.in"
               "${PROJECT_BINARY_DIR}/generated/provenance.cpp" @ONLY)
