#pragma once

#include <cstddef>
#include <string_view>

namespace tdbd {

/// Whether a name matches a pattern in which * stands for any text and ? for any character. Takes at
/// most pattern.size() times name.size() comparisons: a text that the last * covers is extended by one
/// character when the rest does not match, and earlier ones never need to be.
constexpr bool fits(std::string_view pattern, std::string_view name) {
  constexpr std::size_t none = std::string_view::npos;
  std::size_t p = 0, n = 0, star = none, covered = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      covered = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != none) {
      p = star + 1;
      n = ++covered;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace tdbd
