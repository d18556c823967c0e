#include "app/manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/command_help.hpp"
#include "core/provenance.hpp"

namespace tdbd::app {
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
std::string place_item(const WordHelp& word) {
  return fmt::format(".TP\n{} ({}{})\n{}\n", slanted(word.names.front()), plain(word.value),
                     word.is_required ? "" : ", optional", plain(word.text));
}

std::string option_item(const WordHelp& word) {
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
  for (const WordHelp& place : c.places)
    line += place.is_required ? " " + slanted(place.names.front())
                              : " [" + slanted(place.names.front()) + "]";
  return line;
}

std::string section_of(const CommandHelp& c) {
  std::string text =
      fmt::format(".SS {}\n{}\n.PP\n{}.\n", plain(c.name), synopsis_of(c), plain(c.description));
  for (const WordHelp& place : c.places) text += place_item(place);
  for (const WordHelp& option : c.options) text += option_item(option);
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
  for (const WordHelp& option : help_of_options(app)) text += option_item(option);
  text += ".SH COMMANDS\n";
  for (const CommandHelp& c : help_of_commands(app)) text += section_of(c);
  return text + ".SH EXIT STATUS\n" + plain(app.get_footer()) + "\n";
}

}  // namespace tdbd::app
