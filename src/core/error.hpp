#pragma once

#include <stdexcept>
#include <string>

namespace tdbd {

/// The input is wrong: exit code 2. The message names file, line, key, found and expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A folder for results is refused: it is in use, not empty, not ours, or cannot be written to.
struct FolderError : InputError {
  using InputError::InputError;
};

/// The computation failed (a broken invariant, a bound that was hit, a full disk): exit code 1.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace tdbd
