#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace tdbd::mesh {

/// Reads a text file line by line and keeps the line number for messages.
class TextLines {
 public:
  TextLines(std::istream& in, std::string path);

  /// Moves to the next line that has a word before any comment (#). Returns false at the end of the
  /// file.
  bool next();

  const std::vector<std::string>& words() const { return words_; }
  long number() const { return number_; }

  /// The text after the first word, as in the file.
  std::string rest() const;

  /// Parses three finite numbers, starting at word `first`. Throws InputError.
  Vec3 point(std::size_t first) const;

  /// Throws InputError "PATH:LINE: found F, expected E".
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  std::istream& in_;
  std::string path_, line_;
  std::vector<std::string> words_;
  long number_ = 0;
};

}  // namespace tdbd::mesh
