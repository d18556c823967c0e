#pragma once

#include <stdexcept>
#include <string>

namespace tdbd {

/// Invalid input; exit code 2. The message states file, line, key, found and expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An output folder cannot be used: it is locked, not empty, not written by TDBD, or not writable.
struct FolderError : InputError {
  using InputError::InputError;
};

/// A failed computation (a broken invariant, an exceeded bound, a full disk); exit code 1.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace tdbd
