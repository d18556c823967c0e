#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace tdbd::mesh {

/// Reads words and numbers of a text mesh (STL, OBJ, OFF, PLY) and keeps the line number for
/// messages. A # starts a comment that ends with its line. A line whose last character is a
/// backslash continues on the next one.
class TextCursor {
 public:
  /// `text` must outlive the cursor; `line` is the number of its first line in the file. number()
  /// and point() multiply by 10^power.
  TextCursor(std::string_view text, std::string path, long line = 1, int power = 0);

  /// Moves to the next word, across line ends. Returns false at the end of the text.
  bool to_next_word();

  /// Reads the next word. At the end of the text it throws InputError with `expected`.
  std::string_view word(std::string_view expected);

  /// Reads the next word as a finite number, or as a non-negative integer. Throws InputError.
  double number();
  std::int64_t whole(std::string_view expected);

  /// Reads three finite numbers from this line. Throws InputError.
  Vec3 point();

  /// Returns the next word without consuming it; empty at the end of the line.
  std::string_view word_on_this_line();

  /// Consumes the first `bytes` of the text that is left.
  void skip(std::size_t bytes) { text_.remove_prefix(bytes); }

  /// Consumes and returns the rest of the line as in the file, without the blanks around it.
  std::string_view rest_of_line();

  /// Skips the rest of the line, and the lines that continue it.
  void end_line();

  /// Number of bytes not yet read.
  std::size_t left() const { return text_.size(); }

  /// Throws InputError "PATH:LINE: found F, expected E".
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

 private:
  std::string_view take_line();

  std::string_view text_;
  std::string path_;
  long line_;
  int power_;
};

/// The text without the byte-order mark of UTF-8 at its start.
std::string_view without_mark(std::string_view bytes);

/// Whether a word equals a keyword in lower case, in any mixture of upper and lower case.
bool is_keyword(std::string_view word, std::string_view keyword);

/// The word in quotes, for messages.
std::string quoted(std::string_view word);

}  // namespace tdbd::mesh
