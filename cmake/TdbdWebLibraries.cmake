# The libraries of the program for browsers, built by emscripten: headers alone. What is no header has another side:
# loops run on one thread (web/one_thread), units are a table (core/units/unit_table.cpp), results are no files.

# Debian's headers one by one: all of /usr/include would bring the system's C library with it.
set(TDBD_WEB_HEADERS "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${TDBD_WEB_HEADERS}")
foreach(library CGAL boost fmt toml++ nlohmann fast_float)
  if(NOT EXISTS "/usr/include/${library}")
    message(FATAL_ERROR "/usr/include/${library} is not there: bash scripts/setup web")
  endif()
  file(CREATE_LINK "/usr/include/${library}" "${TDBD_WEB_HEADERS}/${library}" SYMBOLIC)
endforeach()

function(tdbd_header_library name)
  cmake_parse_arguments(ARG "" "" "FOLDERS;DEFINES" ${ARGN})
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${name} SYSTEM INTERFACE ${ARG_FOLDERS})
  target_compile_definitions(${name} INTERFACE ${ARG_DEFINES})
endfunction()
tdbd_header_library(fmt::fmt FOLDERS "${TDBD_WEB_HEADERS}" DEFINES FMT_HEADER_ONLY)
tdbd_header_library(tomlplusplus::tomlplusplus FOLDERS "${TDBD_WEB_HEADERS}")
tdbd_header_library(nlohmann_json::nlohmann_json FOLDERS "${TDBD_WEB_HEADERS}")
tdbd_header_library(tdbd_eigen FOLDERS /usr/include/eigen3 DEFINES EIGEN_DONT_PARALLELIZE EIGEN_MAX_ALIGN_BYTES=0)
# WebAssembly has no directed rounding: intervals are widened instead. The decisions are the same, with exact numbers
# used more often.
tdbd_header_library(tdbd_cgal FOLDERS "${TDBD_WEB_HEADERS}"
  DEFINES CGAL_DISABLE_GMP CGAL_ALWAYS_ROUND_TO_NEAREST CGAL_DISABLE_ROUNDING_MATH_CHECK)

# TBB is replaced by a version with one thread, UDUNITS-2 by a table; the libraries that read and write results are left out.
tdbd_header_library(TBB::tbb FOLDERS "${PROJECT_SOURCE_DIR}/web/one_thread")
foreach(library tdbd_udunits PkgConfig::NETCDF PkgConfig::HDF5)
  tdbd_header_library(${library})
endforeach()

# What its standard library (libc++ 13) lacks, before every source.
add_compile_options(-include "${PROJECT_SOURCE_DIR}/web/libcxx13.hpp" "-isystem${TDBD_WEB_HEADERS}" -fwasm-exceptions -w)
add_link_options(-fwasm-exceptions)
