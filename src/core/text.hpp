#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// The text without white space at its ends.
constexpr std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\v\f\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The text with lower-case letters of ASCII; other bytes are unchanged.
std::string lower_case(std::string_view text);

/// Returns the position of the first byte that is not part of valid UTF-8 (RFC 3629); nothing if the
/// whole text is valid.
std::optional<std::size_t> invalid_utf8(std::string_view text);

/// The text, converted from Latin-1 (ISO 8859-1) if it is not UTF-8.
std::string utf8_or_latin1(std::string text);

/// Converts UTF-16 to UTF-8. `low`, `high`: positions (0 or 1) of the
/// low and the high byte in a code unit. A lone surrogate becomes U+FFFD.
std::string utf8_of_utf16(std::string_view bytes, std::size_t low, std::size_t high);

/// Levenshtein distance: the smallest number of insertions, deletions and replacements of
/// characters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the most likely correction of a misspelt name: the closest of `names` (the first of
/// equally close ones). Returns nothing if more than a third of the longer name differs.
std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& names);

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
