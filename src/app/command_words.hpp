#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {

class App;
class ParseError;

}  // namespace CLI

namespace tdbd::app {

/// The list of commands with an example of each; printed by `tdbd` and `tdbd help`.
std::string overview(const CLI::App& app);

/// The output of `tdbd help --man` and `tdbd help --completion`: manual page and bash completion,
/// generated from the command definitions. Nothing for other words.
std::optional<std::string> requested_page(const CLI::App& app,
                                          const std::vector<std::string>& words);

/// Translates the words after the name of the program: `help` alone means the overview (empty
/// result), `help COMMAND` means `COMMAND --help`. Throws InputError with the closest command if
/// the first word is not a command.
std::vector<std::string> parsed_words(const CLI::App& app, std::vector<std::string> words);

/// Message for words that CLI11 rejected: found, expected.
std::string mistake(const CLI::ParseError& error);

}  // namespace tdbd::app
