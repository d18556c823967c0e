# cmake --install: the program, the rooms as static libraries, their headers and the CMake package tdbd.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(TDBD_ROOMS core io rotation mesh bit rock forces dynamics string simulation calibration sweep)
set(TDBD_PACKAGE_FOLDER "${CMAKE_INSTALL_LIBDIR}/cmake/tdbd")

# mesh_cgal and flags only follow the rooms that link them.
foreach(room IN LISTS TDBD_ROOMS ITEMS mesh_cgal flags)
  set_target_properties(tdbd_${room} PROPERTIES EXPORT_NAME ${room})
  add_library(tdbd::${room} ALIAS tdbd_${room})
  install(TARGETS tdbd_${room} EXPORT tdbd ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endforeach()
foreach(room IN LISTS TDBD_ROOMS)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/${room}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/tdbd"
          FILES_MATCHING PATTERN "*.hpp")
endforeach()
target_include_directories(tdbd_flags INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/tdbd>")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/tdbdConfig.cmake.in" "${PROJECT_BINARY_DIR}/tdbdConfig.cmake"
  INSTALL_DESTINATION "${TDBD_PACKAGE_FOLDER}" NO_SET_AND_CHECK_MACRO)
# Before version 1 a minor version may change the headers.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tdbdConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(EXPORT tdbd NAMESPACE tdbd:: FILE tdbdTargets.cmake DESTINATION "${TDBD_PACKAGE_FOLDER}")
install(FILES "${PROJECT_BINARY_DIR}/tdbdConfig.cmake" "${PROJECT_BINARY_DIR}/tdbdConfigVersion.cmake"
        "${PROJECT_SOURCE_DIR}/cmake/TdbdLibraries.cmake" DESTINATION "${TDBD_PACKAGE_FOLDER}")
# Libraries outside the system's own folders are found again where the build found them.
set_target_properties(tdbd PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
install(TARGETS tdbd RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
