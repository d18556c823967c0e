#pragma once

#include <cstddef>
#include <string_view>

namespace tdbd {

/// Whether a name matches a pattern in which * matches any text and ? any character. Takes at most
/// pattern.size() times name.size() comparisons: if the rest does not match, only the text matched
/// by the last * is extended by one character, never that of an earlier one.
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
