#pragma once

#include <gsl/gsl_errno.h>

namespace tdbd::reference {

/// During its lifetime, GSL reports errors by return value instead of terminating the program.
struct QuietGsl {
  gsl_error_handler_t* before = gsl_set_error_handler_off();
  QuietGsl() = default;
  QuietGsl(const QuietGsl&) = delete;
  QuietGsl& operator=(const QuietGsl&) = delete;
  ~QuietGsl() { gsl_set_error_handler(before); }
};

}  // namespace tdbd::reference
