# Everything is a Debian package (scripts/packages.txt); found once, here.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(TBB REQUIRED)
pkg_check_modules(NETCDF REQUIRED IMPORTED_TARGET netcdf)
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET hdf5 hdf5-serial)
find_package(CLI11 QUIET)

# Headers of libraries are not ours to warn about: SYSTEM.
find_path(EIGEN3_INCLUDE_DIR Eigen/Core PATH_SUFFIXES eigen3 REQUIRED)
add_library(tdbd_eigen INTERFACE)
target_include_directories(tdbd_eigen SYSTEM INTERFACE "${EIGEN3_INCLUDE_DIR}")
# No threads inside Eigen, and bits that do not depend on the alignment of a heap block.
target_compile_definitions(tdbd_eigen INTERFACE EIGEN_DONT_PARALLELIZE EIGEN_MAX_ALIGN_BYTES=0)

find_path(UDUNITS_INCLUDE_DIR udunits2.h REQUIRED)
find_library(UDUNITS_LIBRARY udunits2 REQUIRED)
add_library(tdbd_udunits INTERFACE)
target_include_directories(tdbd_udunits SYSTEM INTERFACE "${UDUNITS_INCLUDE_DIR}")
target_link_libraries(tdbd_udunits INTERFACE "${UDUNITS_LIBRARY}")

# Mesh files, and the exact twins of the tests. CGAL's flag -frounding-math follows this target.
find_package(CGAL REQUIRED)
add_library(tdbd_cgal INTERFACE)
target_link_libraries(tdbd_cgal INTERFACE CGAL::CGAL)
# CGAL's exact arithmetic sets rounding modes itself; keep its headers out of our warnings.
target_include_directories(tdbd_cgal SYSTEM INTERFACE ${CGAL_INCLUDE_DIRS})

find_package(nlohmann_json REQUIRED)

# Runge-Kutta and elliptic functions of the twins.
pkg_check_modules(GSL REQUIRED gsl)
add_library(tdbd_gsl INTERFACE)
target_include_directories(tdbd_gsl SYSTEM INTERFACE ${GSL_INCLUDE_DIRS})
target_link_directories(tdbd_gsl INTERFACE ${GSL_LIBRARY_DIRS})
target_link_libraries(tdbd_gsl INTERFACE ${GSL_LIBRARIES})

if(NOT DEFINED TDBD_VERIFICATION OR TDBD_VERIFICATION)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  include(GoogleTest)
endif()
