#include "app/first_words.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/command_help.hpp"
#include "app/completion.hpp"
#include "app/manual.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"

namespace tdbd::app {
namespace {

std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The nearest name, of those that two slips of the finger may have made of it ("rnu"), or else all.
std::string meant_by(const std::string& word, const std::vector<std::string>& names) {
  constexpr std::size_t slips = 2;
  const auto distance = [&](const std::string& name) { return edit_distance(word, name); };
  const auto nearest = std::ranges::min_element(names, {}, distance);
  if (distance(*nearest) <= std::min(slips, word.size() - 1))
    return *nearest + "? (tdbd alone lists all)";
  return fmt::format("one of {}", fmt::join(names, ", "));
}

}  // namespace

std::string overview(const CLI::App& app) {
  std::string text = app.get_description() + "\n\n";
  for (const CLI::App* command : app.get_subcommands({}))
    text += fmt::format("{:<11} {}\n            {}\n", command->get_name(),
                        command->get_description(), example_of(*command));
  return text + "\nAll options of one: tdbd COMMAND --help.\n" + app.get_footer() + "\n";
}

std::optional<std::string> page_asked_for(const CLI::App& app,
                                          const std::vector<std::string>& words) {
  if (words == std::vector<std::string>{"help", "--man"}) return manual_page(app);
  if (words == std::vector<std::string>{"help", "--completion"}) return bash_completion(app);
  return {};
}

std::vector<std::string> understood(const CLI::App& app, std::vector<std::string> words) {
  if (words.empty() || words.front().starts_with('-')) return words;
  if (words.front() == "help") {
    if (words.size() == 1) return {};
    words = {words[1], "--help"};
  }
  const std::vector<std::string> names = names_of(app);
  if (std::ranges::count(names, words.front()) > 0) return words;
  throw InputError(fmt::format("found the command {}, expected {}", words.front(),
                               meant_by(words.front(), names)));
}

std::string unexpected(const std::string& word) {
  if (word.find('=') != std::string::npos && !word.starts_with('-'))
    return fmt::format("found {} alone, expected --set before it: --set '{}'", word, word);
  return fmt::format(
      "found {}, which the command does not expect; tdbd COMMAND --help lists what "
      "it takes",
      word);
}

}  // namespace tdbd::app
