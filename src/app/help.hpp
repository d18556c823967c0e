#pragma once

#include <string>
#include <vector>

namespace CLI {

class App;

}  // namespace CLI

namespace tdbd::app {

/// Help of one word of a command: an option or a positional argument.
struct ArgumentHelp {
  std::vector<std::string> names;  ///< "-o", "--output"; for a positional argument "case"
  std::string value;               ///< "FOLDER", "{ply,off}" (arguments.hpp); empty: a flag
  std::string fallback;            ///< default as shown in the help; empty: none
  std::string text;
  bool is_required = false;
};

/// Help of one command, for the manual page and for shell completion.
struct CommandHelp {
  std::string name, description;
  std::vector<ArgumentHelp> places, options;
  std::vector<std::string> remarks;  ///< lines below the options, except the example
  std::string example;
};

/// Help of all commands, in their order.
std::vector<CommandHelp> help_of_commands(const CLI::App& app);

/// Help of the options of the program itself, which precede a command.
std::vector<ArgumentHelp> help_of_options(const CLI::App& app);

/// The example of a command: the line of its help after "Example: ".
std::string example_of(const CLI::App& command);

}  // namespace tdbd::app

namespace CLI {

class App;

}  // namespace CLI

namespace tdbd::app {

/// The script with which bash completes the words after `tdbd`: commands, options, names of values,
/// files by extension, folders.
std::string bash_completion(const CLI::App& app);

}  // namespace tdbd::app

namespace CLI {

class App;

}  // namespace CLI

namespace tdbd::app {

/// The manual page tdbd(1), for man(7): all commands with their options, remarks and examples.
std::string manual_page(const CLI::App& app);

}  // namespace tdbd::app
