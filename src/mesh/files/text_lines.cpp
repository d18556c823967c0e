#include "mesh/files/text_lines.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace tdbd::mesh {

TextLines::TextLines(std::istream& in, std::string path) : in_(in), path_(std::move(path)) {}

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
    std::string_view word = words_[first + k];
    if (word.starts_with('+')) word.remove_prefix(1);
    double& value = x[static_cast<Eigen::Index>(k)];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      fail('\'' + words_[first + k] + '\'', "a finite number");
  }
  return x;
}

void TextLines::fail(const std::string& found, const std::string& expected) const {
  throw InputError(fmt::format("{}:{}: found {}, expected {}", path_, number_, found, expected));
}

}  // namespace tdbd::mesh
