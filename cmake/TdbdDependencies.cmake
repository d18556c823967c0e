# Everything is a Debian package (scripts/packages.txt, packages-tests.txt). Here: what the program and the tests need.

include(TdbdLibraries)
find_package(CLI11 QUIET)

# Runge-Kutta and elliptic functions of the twins.
if(TDBD_VERIFICATION OR TDBD_BENCHMARKS)
  add_library(tdbd_gsl INTERFACE)
  target_link_libraries(tdbd_gsl INTERFACE PkgConfig::GSL)
endif()

if(TDBD_VERIFICATION)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  include(GoogleTest)
endif()
