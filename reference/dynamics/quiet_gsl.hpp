#pragma once

#include <gsl/gsl_errno.h>

namespace tdbd::reference {

/// While this lives GSL reports by return value instead of ending the program.
struct QuietGsl {
  gsl_error_handler_t* before = gsl_set_error_handler_off();
  QuietGsl() = default;
  QuietGsl(const QuietGsl&) = delete;
  QuietGsl& operator=(const QuietGsl&) = delete;
  ~QuietGsl() { gsl_set_error_handler(before); }
};

}  // namespace tdbd::reference
