#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace tdbd::mesh {

/// Reads words and numbers from a text, across line ends, and keeps the line number for messages. A
/// # starts a comment that ends with its line.
class TextCursor {
 public:
  /// `text` must outlive the cursor; `line` is the number of its first line in the file. number()
  /// multiplies by 10^power.
  TextCursor(std::string_view text, std::string path, long line = 1, int power = 0);

  /// Reads the next word. At the end of the text it throws InputError with `expected`.
  std::string_view word(std::string_view expected);

  /// Reads the next word as a finite number, or as a non-negative integer. Throws InputError.
  double number();
  std::int64_t whole(std::string_view expected);

  /// Returns the next word without consuming it; empty at the end of the line.
  std::string_view word_on_this_line();

  /// Skips the rest of the line.
  void end_line();

  /// Number of bytes not yet read.
  std::size_t left() const { return text_.size(); }

  /// Throws InputError "PATH:LINE: found F, expected E".
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

 private:
  std::string_view text_;
  std::string path_;
  long line_;
  int power_;
};

/// Reads a text file line by line and keeps the line number for messages.
class TextLines {
 public:
  /// point() multiplies by 10^power.
  TextLines(std::istream& in, std::string path, int power = 0);

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
  int power_;
};

}  // namespace tdbd::mesh
