# Everything is a Debian package (scripts/packages.txt). Here: what only the program and the tests need.

include(TdbdLibraries)
find_package(CLI11 QUIET)

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
