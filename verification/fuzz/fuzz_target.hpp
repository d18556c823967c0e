#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tdbd::fuzz {

/// A reader that takes any bytes. `take` returns whether they were read or refused with the error that the reader's header
/// names; any other exception leaves it, and is a failure, as are a signal, a sanitizer's report and a long wait.
struct FuzzTarget {
  std::string_view name;
  void (*take)(std::string_view bytes);
};

/// Every reader of the program, by name.
std::span<const FuzzTarget> fuzz_targets();

/// The one of this name; null: there is none.
const FuzzTarget* fuzz_target(std::string_view name);

}  // namespace tdbd::fuzz
