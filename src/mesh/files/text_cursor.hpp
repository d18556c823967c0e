#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tdbd::mesh {

/// Reads words and numbers from a text, across line ends, and keeps the line number for messages. A
/// # starts a comment that ends with its line.
class TextCursor {
 public:
  /// `text` must outlive the cursor; `line` is the number of its first line in the file.
  TextCursor(std::string_view text, std::string path, long line = 1);

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
};

}  // namespace tdbd::mesh
