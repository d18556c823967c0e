#pragma once

#include <CGAL/assertions_behaviour.h>

namespace tdbd::mesh {

/// Suppresses the messages that CGAL prints on standard error. Failed assertions still throw, and
/// TDBD reports them with the place in the mesh. The destructor restores the previous handlers.
class QuietCgal {
 public:
  QuietCgal()
      : error_(CGAL::set_error_handler(&ignore)), warning_(CGAL::set_warning_handler(&ignore)) {}
  ~QuietCgal() {
    CGAL::set_error_handler(error_);
    CGAL::set_warning_handler(warning_);
  }
  QuietCgal(const QuietCgal&) = delete;
  QuietCgal& operator=(const QuietCgal&) = delete;

 private:
  static void ignore(const char*, const char*, const char*, int, const char*) {}

  CGAL::Failure_function error_, warning_;
};

}  // namespace tdbd::mesh
