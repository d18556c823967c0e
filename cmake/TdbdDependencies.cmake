# Everything is a Debian package (scripts/packages.txt, packages-tests.txt). Here: what the program and the tests need.

include(TdbdLibraries)
find_package(CLI11 QUIET)

# CGAL stops a program at its start if directed rounding does not work. Under valgrind it does not: the preset `count`
# leaves the check out. What such a program decides by intervals is not certain, good for counting and nothing else.
option(TDBD_CGAL_ROUNDING_CHECK "CGAL refuses to start where directed rounding does not work" ON)
if(NOT TDBD_CGAL_ROUNDING_CHECK)
  target_compile_definitions(tdbd_cgal INTERFACE CGAL_DISABLE_ROUNDING_MATH_CHECK)
endif()

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
