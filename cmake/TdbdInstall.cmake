# cmake --install: the program, the modules as static libraries, the public headers and the CMake package
# tdbd.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(TDBD_MODULES core io rotation mesh bit rock forces dynamics string simulation calibration sweep)
set(TDBD_PACKAGE_FOLDER "${CMAKE_INSTALL_LIBDIR}/cmake/tdbd")

# mesh_cgal and flags only follow the modules that link them.
foreach(module IN LISTS TDBD_MODULES ITEMS mesh_cgal flags)
  set_target_properties(tdbd_${module} PROPERTIES EXPORT_NAME ${module})
  add_library(tdbd::${module} ALIAS tdbd_${module})
  install(TARGETS tdbd_${module} EXPORT tdbd ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endforeach()
# The public headers and all that they include.
set(list_of_headers "${PROJECT_SOURCE_DIR}/src/public_headers.txt")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${list_of_headers}")
file(STRINGS "${list_of_headers}" waiting REGEX "^[^#]")
set(installed "")
while(waiting)
  list(POP_FRONT waiting header)
  if(NOT header IN_LIST installed AND EXISTS "${PROJECT_SOURCE_DIR}/src/${header}")
    list(APPEND installed "${header}")
    file(STRINGS "${PROJECT_SOURCE_DIR}/src/${header}" includes REGEX "^#include \"")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${include}")
      list(APPEND waiting "${included}")
    endforeach()
  endif()
endwhile()
foreach(header IN LISTS installed)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES "${PROJECT_SOURCE_DIR}/src/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/tdbd/${folder}")
endforeach()
target_include_directories(tdbd_flags INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/tdbd>")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/tdbdConfig.cmake.in" "${PROJECT_BINARY_DIR}/tdbdConfig.cmake"
  INSTALL_DESTINATION "${TDBD_PACKAGE_FOLDER}" NO_SET_AND_CHECK_MACRO)
# Within a major version the public headers only gain declarations (docs/reference/stability.md).
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tdbdConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(EXPORT tdbd NAMESPACE tdbd:: FILE tdbdTargets.cmake DESTINATION "${TDBD_PACKAGE_FOLDER}")
install(FILES "${PROJECT_BINARY_DIR}/tdbdConfig.cmake" "${PROJECT_BINARY_DIR}/tdbdConfigVersion.cmake"
        "${PROJECT_SOURCE_DIR}/cmake/TdbdLibraries.cmake" DESTINATION "${TDBD_PACKAGE_FOLDER}")
# Libraries outside the system's own folders are found again where the build found them.
set_target_properties(tdbd PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
install(TARGETS tdbd RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# The example cases with their bits and rocks, for the tutorials.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/cases" DESTINATION "${CMAKE_INSTALL_DATADIR}/tdbd"
  PATTERN "*.py" EXCLUDE PATTERN "__pycache__" EXCLUDE)
# The scripts of the commands draw, page, report and compare.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/reports/" DESTINATION "${CMAKE_INSTALL_DATADIR}/tdbd/reports"
  FILES_MATCHING PATTERN "*.py" PATTERN "*.j2" PATTERN "*.js" PATTERN "*.css"
  PATTERN "studies" EXCLUDE PATTERN "api" EXCLUDE PATTERN "__pycache__" EXCLUDE)
