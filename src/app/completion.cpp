#include "app/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/command_help.hpp"

namespace tdbd::app {
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
  for (const WordHelp& option : c.options) {
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
  for (const WordHelp& option : c.options)
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
  for (const WordHelp& option : help_of_options(app)) first += " " + option.names.back();
  return head + fmt::format("  ((COMP_CWORD == 1)) && {{ _tdbd_words \"{}\"; return; }}\n", first) +
         "  [[ $word == = || $before == = ]] && return  # a value behind KEY=\n"
         "  case \"$command $before\" in\n" +
         values + "  esac\n  if [[ $word == -* ]]; then\n    case $command in\n" + options +
         "    esac\n    return\n  fi\n  case \"$command $((COMP_CWORD - 1))\" in\n" + places +
         fmt::format("    \"help 1\") _tdbd_words \"{}\" ;;\n", names_of(commands)) +
         "  esac\n}\n\ncomplete -F _tdbd tdbd\n";
}

}  // namespace tdbd::app
