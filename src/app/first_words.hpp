#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace tdbd::app {

/// The commands with an example of each: what `tdbd` and `tdbd help` print.
std::string overview(const CLI::App& app);

/// What `tdbd help --man` and `tdbd help --completion` print: the manual page and bash's completion,
/// made of what the program knows of itself. Nothing for other words.
std::optional<std::string> page_asked_for(const CLI::App& app,
                                          const std::vector<std::string>& words);

/// What the words after the program's name mean: `help` alone is an overview, `help COMMAND` is
/// `COMMAND --help`. Throws InputError, with the nearest command, when the first word is none.
std::vector<std::string> understood(const CLI::App& app, std::vector<std::string> words);

/// What was wrong with words that CLI11 refused: found, expected.
std::string mistake(const CLI::ParseError& error);

}  // namespace tdbd::app
