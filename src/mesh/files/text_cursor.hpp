#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tdbd::mesh {

/// Reads words and numbers from a text, wherever its lines end, and keeps the line number for messages. From # to the
/// end of a line is a comment.
class TextCursor {
 public:
  /// `text` must outlive the cursor; `line` is the number of its first line in the file.
  TextCursor(std::string_view text, std::string path, long line = 1);

  /// The next word. At the end of the text: InputError that names what was expected.
  std::string_view word(std::string_view expected);

  /// The next word as a number: finite, or whole and not negative. Throws InputError.
  double number();
  std::int64_t whole(std::string_view expected);

  /// The next word, without moving to it; empty at the end of the line.
  std::string_view word_on_this_line();

  /// Leaves out the rest of the line.
  void end_line();

  /// How many bytes are left.
  std::size_t left() const { return text_.size(); }

  /// Throws InputError "PATH:LINE: found F, expected E".
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

 private:
  std::string_view text_;
  std::string path_;
  long line_;
};

}  // namespace tdbd::mesh
