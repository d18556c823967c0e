#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace tdbd::app {

/// To standard output. A failure does not end the command, whose files matter more; after_output
/// tells of it.
void write_out(const std::string& text);

template <class... T>
void say(fmt::format_string<T...> text, T&&... values) {
  write_out(fmt::format(text, std::forward<T>(values)...));
}

/// The exit code of a command that is done: 1, with a message, when its output did not arrive. A
/// reader that closed its end of a pipe has read all that it wanted: no failure.
int after_output(int exit_code);

}  // namespace tdbd::app
