#include "mesh/files/text_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "mesh/files/length_unit.hpp"

namespace tdbd::mesh {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// The bytes of a backslash and the line end after it; 0 if the text does not start with them.
std::size_t continuation(std::string_view text) {
  if (!text.starts_with('\\')) return 0;
  const std::size_t end = text.find_first_not_of(" \t\r", 1);
  if (end == std::string_view::npos) return text.size();
  return text[end] == '\n' ? end + 1 : 0;
}

}  // namespace

TextCursor::TextCursor(std::string_view text, std::string path, long line, int power)
    : text_(text), path_(std::move(path)), line_(line), power_(power) {}

std::string_view TextCursor::word_on_this_line() {
  for (;;) {
    std::size_t first = 0;
    while (first < text_.size() && is_blank(text_[first])) ++first;
    text_.remove_prefix(first);
    const std::size_t bytes = continuation(text_);
    if (bytes == 0) break;
    text_.remove_prefix(bytes);
    ++line_;
  }
  std::size_t end = 0;
  const auto ends = [&](char c) {  // the # of a number such as 1.#QNAN starts no comment
    return is_blank(c) || c == '\n' || (c == '#' && (end == 0 || text_[end - 1] != '.'));
  };
  while (end < text_.size() && !ends(text_[end])) ++end;
  if (end > 1 && text_[end - 1] == '\\' && continuation(text_.substr(end - 1)) > 0) --end;
  return text_.substr(0, end);
}

bool TextCursor::to_next_word() {
  while (word_on_this_line().empty()) {
    if (text_.empty()) return false;
    end_line();
  }
  return true;
}

std::string_view TextCursor::word(std::string_view expected) {
  if (!to_next_word()) fail("the end of the file", expected);
  const std::string_view found = word_on_this_line();
  skip(found.size());
  return found;
}

double TextCursor::number() {
  const std::string_view found = word("a finite number");
  const auto value = decimal_number(found, power_);
  if (!value) fail(quoted(found), "a finite number");
  return *value;
}

std::int64_t TextCursor::whole(std::string_view expected) {
  std::string_view found = word(expected), digits = found;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value < 0)
    fail(quoted(found), expected);
  return value;
}

Vec3 TextCursor::point() {
  Vec3 x;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (word_on_this_line().empty()) fail(fmt::format("{} numbers", k), "three");
    x[k] = number();
  }
  return x;
}

std::string_view TextCursor::take_line() {
  const std::size_t end = std::min(text_.find('\n'), text_.size());
  const std::string_view line = text_.substr(0, end);
  text_.remove_prefix(std::min(end + 1, text_.size()));
  if (!text_.empty()) ++line_;
  return line;
}

std::string_view TextCursor::rest_of_line() {
  const std::string_view rest = text_.substr(0, std::min(text_.find('\n'), text_.size()));
  text_.remove_prefix(rest.size());  // not the line end: messages about the rest name its line
  return trimmed(rest);
}

void TextCursor::end_line() {
  for (bool continues = true; continues;) {
    const std::string_view line = take_line();
    const std::size_t last = line.find_last_not_of(" \t\r");
    continues = last != std::string_view::npos && line[last] == '\\' &&
                line.find('#') == std::string_view::npos;
  }
}

void TextCursor::fail(std::string_view found, std::string_view expected) const {
  throw InputError(fmt::format("{}:{}: found {}, expected {}", path_, line_, found, expected));
}

std::string_view without_mark(std::string_view bytes) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return bytes.starts_with(mark) ? bytes.substr(mark.size()) : bytes;
}

bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(word, keyword, {},
                            [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
}

std::string quoted(std::string_view word) { return fmt::format("'{}'", word); }

}  // namespace tdbd::mesh
