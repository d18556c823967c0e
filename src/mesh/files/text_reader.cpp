#include "mesh/files/text_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "mesh/files/length_unit.hpp"

namespace tdbd::mesh {
namespace {

constexpr std::string_view blanks = " \t\v\f\r", ends = " \t\v\f\r\n#";

/// Parses a number that must fill the whole word; a leading plus sign is allowed.
template <class Number>
bool fills(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

std::string quoted(std::string_view word) { return fmt::format("'{}'", word); }

}  // namespace

TextCursor::TextCursor(std::string_view text, std::string path, long line, int power)
    : text_(text), path_(std::move(path)), line_(line), power_(power) {}

std::string_view TextCursor::word_on_this_line() {
  text_.remove_prefix(std::min(text_.find_first_not_of(blanks), text_.size()));
  return text_.substr(0, text_.find_first_of(ends));
}

std::string_view TextCursor::word(std::string_view expected) {
  std::string_view found = word_on_this_line();
  for (; found.empty(); found = word_on_this_line()) {
    if (text_.empty()) fail("the end of the file", expected);
    end_line();
  }
  text_.remove_prefix(found.size());
  return found;
}

double TextCursor::number() {
  const std::string_view found = word("a finite number");
  const auto value = decimal_number(found, power_);
  if (!value) fail(quoted(found), "a finite number");
  return *value;
}

std::int64_t TextCursor::whole(std::string_view expected) {
  const std::string_view found = word(expected);
  std::int64_t value = 0;
  if (!fills(found, value) || value < 0) fail(quoted(found), expected);
  return value;
}

void TextCursor::end_line() {
  const std::size_t end = text_.find('\n');
  if (end != std::string_view::npos) ++line_;
  text_.remove_prefix(std::min(end == std::string_view::npos ? end : end + 1, text_.size()));
}

void TextCursor::fail(std::string_view found, std::string_view expected) const {
  throw InputError(fmt::format("{}:{}: found {}, expected {}", path_, line_, found, expected));
}

TextLines::TextLines(std::istream& in, std::string path, int power)
    : in_(in), path_(std::move(path)), power_(power) {}

bool TextLines::next() {
  words_.clear();
  while (words_.empty()) {
    if (!std::getline(in_, line_)) return false;
    ++number_;
    std::istringstream text(line_.substr(0, line_.find('#')));
    for (std::string word; text >> word;) words_.push_back(word);
  }
  return true;
}

std::string TextLines::rest() const {
  if (words_.size() < 2) return "";
  const std::size_t first = line_.find(words_[0]) + words_[0].size();
  return std::string(trimmed(std::string_view(line_).substr(first)));
}

Vec3 TextLines::point(std::size_t first) const {
  if (words_.size() < first + 3)
    fail(fmt::format("{} words", words_.size()), fmt::format("'{}' and three numbers", words_[0]));
  Vec3 x = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = decimal_number(words_[first + k], power_);
    if (!value) fail('\'' + words_[first + k] + '\'', "a finite number");
    x[static_cast<Eigen::Index>(k)] = *value;
  }
  return x;
}

void TextLines::fail(const std::string& found, const std::string& expected) const {
  throw InputError(fmt::format("{}:{}: found {}, expected {}", path_, number_, found, expected));
}

}  // namespace tdbd::mesh
