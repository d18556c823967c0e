# The libraries that TDBD links. Read by its own build and, installed beside tdbdConfig.cmake, by every project that
# calls find_package(tdbd): nothing here may name a folder of the build.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
pkg_check_modules(NETCDF REQUIRED IMPORTED_TARGET netcdf)
pkg_check_modules(GSL REQUIRED IMPORTED_TARGET gsl)
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET hdf5 hdf5-serial)

# SYSTEM: no warnings about headers of libraries.
if(NOT TARGET tdbd_eigen)
  find_path(EIGEN3_INCLUDE_DIR Eigen/Core PATH_SUFFIXES eigen3 REQUIRED)
  add_library(tdbd_eigen INTERFACE IMPORTED)
  target_include_directories(tdbd_eigen SYSTEM INTERFACE "${EIGEN3_INCLUDE_DIR}")
  # No threads inside Eigen, and bits that do not depend on the alignment of a heap block. Both change the layout of
  # types in headers of TDBD, so that code that includes them must be compiled with the same settings.
  target_compile_definitions(tdbd_eigen INTERFACE EIGEN_DONT_PARALLELIZE EIGEN_MAX_ALIGN_BYTES=0)
endif()

if(NOT TARGET tdbd_udunits)
  find_path(UDUNITS_INCLUDE_DIR udunits2.h REQUIRED)
  find_library(UDUNITS_LIBRARY udunits2 REQUIRED)
  add_library(tdbd_udunits INTERFACE IMPORTED)
  target_include_directories(tdbd_udunits SYSTEM INTERFACE "${UDUNITS_INCLUDE_DIR}")
  target_link_libraries(tdbd_udunits INTERFACE "${UDUNITS_LIBRARY}")
endif()

# Repair and exact predicates of meshes, and the exact twins of the tests. CGAL's flag -frounding-math follows this
# target.
if(NOT TARGET tdbd_cgal)
  find_package(CGAL REQUIRED)
  add_library(tdbd_cgal INTERFACE IMPORTED)
  target_link_libraries(tdbd_cgal INTERFACE CGAL::CGAL)
  # CGAL's exact arithmetic sets rounding modes itself; keep its headers out of our warnings.
  target_include_directories(tdbd_cgal SYSTEM INTERFACE ${CGAL_INCLUDE_DIRS})
endif()
