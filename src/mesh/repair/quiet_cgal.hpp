#pragma once

#include <CGAL/assertions_behaviour.h>

namespace tdbd::mesh {

/// Suppresses the messages that CGAL prints on standard error, which request bug reports. Failed
/// assertions still throw, and TDBD reports them with the place in the mesh. The suppression stays:
/// the handlers are shared by all threads, so none may restore them while another one needs them.
class QuietCgal {
 public:
  QuietCgal() {
    [[maybe_unused]] static const bool done = [] {
      CGAL::set_error_handler(&ignore);
      CGAL::set_warning_handler(&ignore);
      return true;
    }();
  }

 private:
  static void ignore(const char*, const char*, const char*, int, const char*) {}
};

}  // namespace tdbd::mesh
