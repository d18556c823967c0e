#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace tdbd::app {

/// Writes to standard output. A failure does not end the command, whose files are more important;
/// after_output reports it.
void write_out(const std::string& text);

template <class... T>
void say(fmt::format_string<T...> text, T&&... values) {
  write_out(fmt::format(text, std::forward<T>(values)...));
}

/// The final exit code of a command: 1, with a message, if its output could not be written. A pipe
/// closed by its reader is not a failure.
int after_output(int exit_code);

}  // namespace tdbd::app
