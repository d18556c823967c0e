#include "app/command_help.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

namespace tdbd::app {
namespace {

constexpr const char* example_head = "Example: ";

/// "INT" of "INT:INT in [1 - 8]", "{a,b}" of "TEXT:{a,b}".
std::string value_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto colon = type.find(':');
  if (colon == std::string::npos) return type;
  return type[colon + 1] == '{' ? type.substr(colon + 1) : type.substr(0, colon);
}

WordHelp help_of(const CLI::Option& option) {
  WordHelp word{.names = {},
                .value = value_of(option),
                .fallback = option.get_default_str(),
                .text = option.get_description(),
                .is_required = option.get_required()};
  for (const std::string& name : option.get_snames()) word.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) word.names.push_back("--" + name);
  if (option.get_positional()) word.names = {option.get_name()};
  return word;
}

CommandHelp help_of(const CLI::App& command) {
  CommandHelp help{.name = command.get_name(),
                   .description = command.get_description(),
                   .places = {},
                   .options = {},
                   .remarks = {},
                   .example = example_of(command)};
  for (const CLI::Option* option : command.get_options())
    (option->get_positional() ? help.places : help.options).push_back(help_of(*option));
  std::istringstream footer(command.get_footer());
  for (std::string line; std::getline(footer, line);)
    if (!line.starts_with(example_head)) help.remarks.push_back(line);
  return help;
}

}  // namespace

std::vector<CommandHelp> help_of_commands(const CLI::App& app) {
  std::vector<CommandHelp> all;
  for (const CLI::App* command : app.get_subcommands({})) all.push_back(help_of(*command));
  return all;
}

std::vector<WordHelp> help_of_options(const CLI::App& app) { return help_of(app).options; }

std::string example_of(const CLI::App& command) {
  const std::string text = command.get_footer(), head = example_head;
  const auto at = text.find(head);
  if (at == std::string::npos) return "tdbd " + command.get_name() + " --help";
  return text.substr(at + head.size(), text.find('\n', at) - at - head.size());
}

}  // namespace tdbd::app
