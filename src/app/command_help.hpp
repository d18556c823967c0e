#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tdbd::app {

/// A word that a command takes: an option, or one by its place.
struct WordHelp {
  std::vector<std::string> names;  ///< "-o", "--output"; of one by its place "case"
  std::string value;               ///< "FOLDER", "{ply,off}" (arguments.hpp); empty: a flag
  std::string fallback;            ///< as help shows it; empty: none
  std::string text;
  bool is_required = false;
};

/// What the program knows of one of its commands: for the manual and for completion.
struct CommandHelp {
  std::string name, description;
  std::vector<WordHelp> places, options;
  std::vector<std::string> remarks;  ///< lines below the options, but for the example
  std::string example;
};

/// All commands in their order.
std::vector<CommandHelp> help_of_commands(const CLI::App& app);

/// The options that stand before a command.
std::vector<WordHelp> help_of_options(const CLI::App& app);

/// The line of a command's help that begins with "Example: ", without that.
std::string example_of(const CLI::App& command);

}  // namespace tdbd::app
