#include "app/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "core/provenance.hpp"

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

ArgumentHelp help_of(const CLI::Option& option) {
  ArgumentHelp word{.names = {},
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

std::vector<ArgumentHelp> help_of_options(const CLI::App& app) { return help_of(app).options; }

std::string example_of(const CLI::App& command) {
  const std::string text = command.get_footer(), head = example_head;
  const auto at = text.find(head);
  if (at == std::string::npos) return "tdbd " + command.get_name() + " --help";
  return text.substr(at + head.size(), text.find('\n', at) - at - head.size());
}

namespace {

constexpr const char* head =
    R"(# Completion of tdbd in bash. Made by `tdbd help --completion`; do not edit.

_tdbd_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }

_tdbd_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
}

# Files of these endings, and the folders on the way to them.
_tdbd_files() {
  local ending
  _tdbd_folders
  for ending in "$@"; do
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -X "!*.$ending" -- "$word")
  done
}

_tdbd() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
  COMPREPLY=()
)";

/// Shell command that completes a value; ":" if there is nothing to offer.
std::string shell_for(const std::string& value) {
  const std::string file = "FILE.";
  if (value == "FOLDER") return "_tdbd_folders";
  if (value.starts_with(file)) {
    std::string endings = value.substr(file.size());
    std::ranges::replace(endings, '|', ' ');
    return "_tdbd_files " + endings;
  }
  if (!value.starts_with('{')) return ":";
  std::string names = value.substr(1, value.size() - 2);
  std::ranges::replace(names, ',', ' ');
  return "_tdbd_words \"" + names + "\"";
}

std::string names_of(const std::vector<CommandHelp>& commands) {
  std::string names;
  for (const CommandHelp& c : commands) names += c.name + " ";
  return names + "help";
}

/// Completion of the values of options.
std::string cases_of_values(const CommandHelp& c) {
  std::string lines;
  for (const ArgumentHelp& option : c.options) {
    if (option.value.empty()) continue;
    std::string patterns;
    for (const std::string& name : option.names)
      patterns += fmt::format("{}\"{} {}\"", patterns.empty() ? "" : " | ", c.name, name);
    lines += fmt::format("    {}) {}; return ;;\n", patterns, shell_for(option.value));
  }
  return lines;
}

/// Completion of long option names; short names need none.
std::string case_of_options(const CommandHelp& c) {
  std::string names;
  for (const ArgumentHelp& option : c.options)
    names += (names.empty() ? "" : " ") + option.names.back();
  return fmt::format("      {}) _tdbd_words \"{}\" ;;\n", c.name, names);
}

/// Completion of positional arguments. The last one is also used for all that follow.
std::string cases_of_places(const CommandHelp& c) {
  std::string lines;
  for (std::size_t i = 0; i < c.places.size(); ++i)
    lines += fmt::format("    {}) {} ;;\n",
                         i + 1 < c.places.size() ? fmt::format("\"{} {}\"", c.name, i + 1)
                                                 : fmt::format("\"{} \"*", c.name),
                         shell_for(c.places[i].value));
  return lines;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  const std::vector<CommandHelp> commands = help_of_commands(app);
  std::string values, options, places;
  for (const CommandHelp& c : commands) {
    values += cases_of_values(c);
    options += case_of_options(c);
    places += cases_of_places(c);
  }
  std::string first = names_of(commands);
  for (const ArgumentHelp& option : help_of_options(app)) first += " " + option.names.back();
  return head + fmt::format("  ((COMP_CWORD == 1)) && {{ _tdbd_words \"{}\"; return; }}\n", first) +
         "  [[ $word == = || $before == = ]] && return  # a value behind KEY=\n"
         "  case \"$command $before\" in\n" +
         values + "  esac\n  if [[ $word == -* ]]; then\n    case $command in\n" + options +
         "    esac\n    return\n  fi\n  case \"$command $((COMP_CWORD - 1))\" in\n" + places +
         fmt::format("    \"help 1\") _tdbd_words \"{}\" ;;\n", names_of(commands)) +
         "  esac\n}\n\ncomplete -F _tdbd tdbd\n";
}

namespace {

/// Escapes text so that it is printed literally. Carets, tildes and full stops at the start of a
/// text are not escaped; a test checks that there are none.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      default:
        out += c;
    }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string slanted(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

/// A positional argument and its description.
std::string place_item(const ArgumentHelp& word) {
  return fmt::format(".TP\n{} ({}{})\n{}\n", slanted(word.names.front()), plain(word.value),
                     word.is_required ? "" : ", optional", plain(word.text));
}

std::string option_item(const ArgumentHelp& word) {
  std::string names;
  for (const std::string& name : word.names) names += (names.empty() ? "" : ", ") + bold(name);
  std::string text = plain(word.text);
  if (word.is_required) text += "; required";
  if (!word.value.empty() && !word.fallback.empty())
    text += fmt::format("; default: {}", plain(word.fallback));
  return fmt::format(".TP\n{}{}\n{}\n", names, word.value.empty() ? "" : " " + slanted(word.value),
                     text);
}

std::string synopsis_of(const CommandHelp& c) {
  std::string line = bold("tdbd " + c.name) + " [" + slanted("options") + "]";
  for (const ArgumentHelp& place : c.places)
    line += place.is_required ? " " + slanted(place.names.front())
                              : " [" + slanted(place.names.front()) + "]";
  return line;
}

std::string section_of(const CommandHelp& c) {
  std::string text =
      fmt::format(".SS {}\n{}\n.PP\n{}.\n", plain(c.name), synopsis_of(c), plain(c.description));
  for (const ArgumentHelp& place : c.places) text += place_item(place);
  for (const ArgumentHelp& option : c.options) text += option_item(option);
  if (!c.remarks.empty()) text += ".PP\n";
  for (const std::string& remark : c.remarks) text += plain(remark) + "\n";
  return text + ".PP\nExample:\n.PP\n.EX\n    " + plain(c.example) + "\n.EE\n";
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text = "'\\\" Made by `tdbd help \\-\\-man`; do not edit.\n";
  text +=
      fmt::format(".TH TDBD 1 \"\" \"tdbd {}\" \"User Commands\"\n", plain(provenance().version));
  const std::string what = app.get_description();  // "TDBD: ..."
  text += ".SH NAME\ntdbd \\- " + plain(what.substr(what.find(": ") + 2)) + "\n.SH SYNOPSIS\n" +
          bold("tdbd") + " " + slanted("command") + " [" + slanted("options") + "]\n";
  text += ".SH DESCRIPTION\n" + plain(what) + ".\n";
  text += bold("tdbd") + " alone lists the commands with an example of each, " + bold("tdbd") +
          " " + slanted("command") + " " + bold("--help") + " describes one of them.\n" +
          bold("tdbd keys") +
          " lists the keys of input files: unit, default, range, meaning.\n.SH OPTIONS\n";
  for (const ArgumentHelp& option : help_of_options(app)) text += option_item(option);
  text += ".SH COMMANDS\n";
  for (const CommandHelp& c : help_of_commands(app)) text += section_of(c);
  return text + ".SH EXIT STATUS\n" + plain(app.get_footer()) + "\n";
}

}  // namespace tdbd::app
