#include "app/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <regex>

#include "app/help.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "simulation/result/run.hpp"

namespace tdbd::app {

int guarded(const std::function<int()>& body) {
  try {
    return body();
  } catch (const InputError& e) {
    std::fprintf(stderr, "tdbd: %s\n", e.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& e) {
    std::fprintf(stderr, "tdbd: %s: %s\n", e.path1().c_str(), e.code().message().c_str());
    return is_resource_error(e.code()) ? 1 : 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "tdbd: %s\n", error_message_of(e));
    return 1;
  }
}

namespace {

std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Suggestion for a mistyped command: the closest name if it differs by at most two typing errors
/// ("rnu"), otherwise all names.
std::string suggested_command(const std::string& word, const std::vector<std::string>& names) {
  constexpr std::size_t slips = 2;
  const auto distance = [&](const std::string& name) { return edit_distance(word, name); };
  const auto nearest = std::ranges::min_element(names, {}, distance);
  if (distance(*nearest) <= std::min(slips, word.size() - 1))
    return *nearest + "? (tdbd without a command lists all)";
  return fmt::format("one of {}", fmt::join(names, ", "));
}

constexpr const char* listed = "; tdbd COMMAND --help lists its arguments";

/// Describes words that the command does not accept, and what to write instead.
std::string unexpected(const std::string& words) {
  if (words.find('=') != std::string::npos && !words.starts_with('-'))
    return fmt::format("found {} without --set, expected --set '{}'", words, words);
  return fmt::format("found {}, which is not an argument of the command{}", words, listed);
}

/// A message of CLI11 and its replacement. Other messages are not changed.
struct Rewording {
  const char *said, *ours;
};
constexpr std::array rewordings{
    Rewording{R"(A subcommand is required)", "found no command, expected one"},
    Rewording{R"((\S+) is required)", "found no $1, expected one"},
    Rewording{R"((\S+): (?:Value )?(.+) not in (?:range )?(.+))", "$1: found $2, expected $3"},
    Rewording{R"((\S+): 1 required (?:INT:|FLOAT:|TEXT:)?(.+) missing)",
              "$1: found nothing, expected $2"},
    Rewording{R"(Could not convert: (\S+) = (.*))", "$1: found $2, expected a number"},
    Rewording{R"((\S+): At Most 1 required but received (\d+))",
              "$1: found $2 times, expected once"},
    Rewording{R"((\S+) excludes (\S+))", "found $1 and $2, expected one of them"}};

}  // namespace

std::string overview(const CLI::App& app) {
  std::string text = app.get_description() + "\n\n";
  for (const CLI::App* command : app.get_subcommands({}))
    text += fmt::format("{:<11} {}\n            {}\n", command->get_name(),
                        command->get_description(), example_of(*command));
  return text + "\nOptions of a command: tdbd COMMAND --help.\n" + app.get_footer() + "\n";
}

std::optional<std::string> requested_page(const CLI::App& app,
                                          const std::vector<std::string>& words) {
  if (words == std::vector<std::string>{"help", "--man"}) return manual_page(app);
  if (words == std::vector<std::string>{"help", "--completion"}) return bash_completion(app);
  return {};
}

std::vector<std::string> parsed_words(const CLI::App& app, std::vector<std::string> words) {
  if (words.empty() || words.front().starts_with('-')) return words;
  if (words.front() == "help") {
    if (words.size() == 1) return {};
    words = {words[1], "--help"};
  }
  const std::vector<std::string> names = names_of(app);
  if (std::ranges::count(names, words.front()) > 0) return words;
  throw InputError(fmt::format("found the command {}, expected {}", words.front(),
                               suggested_command(words.front(), names)));
}

std::string mistake(const CLI::ParseError& error) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return unexpected(
        text.substr(text.find(": ") + 2));  // "...not expected: WORD" or "...: WORD WORD"
  const auto said = std::ranges::find_if(
      rewordings, [&](const Rewording& r) { return std::regex_match(text, std::regex(r.said)); });
  return (said == rewordings.end() ? text
                                   : std::regex_replace(text, std::regex(said->said), said->ours)) +
         listed;
}

namespace fs = std::filesystem;

void add_case(CLI::App& command, ResultArguments& a, const ResultHelp& help) {
  command.add_option("case", a.case_file, help.case_file)->required()->type_name(a_toml_file);
}

void add_set(CLI::App& command, std::vector<std::string>& overrides, const std::string& help) {
  command.add_option("--set", overrides, help)
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "number of threads; results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

void add_result_options(CLI::App& command, ResultArguments& a, const ResultHelp& help) {
  command.add_option("-o,--output", a.folder, "result folder; default " + help.folder)
      ->type_name(a_folder);
  add_set(command, a.overrides,
          "override a key; may be repeated: " + help.set + "; `tdbd keys` lists the keys");
  command.add_flag("--force", a.force, "replace the results in the folder");
  command.add_flag("--quiet", a.quiet, help.quiet);
}

void add_resume(CLI::App& command, ResultArguments& a) {
  CLI::Option* resumed = command.add_option(
      "--resume", a.resumed, "resume the interrupted run in this folder (instead of a case)");
  resumed->type_name(a_folder);
  command.get_option("case")->required(false)->excludes(resumed);
  for (const char* other : {"--output", "--force"}) command.get_option(other)->excludes(resumed);
}

int begin_or_resume(const ResultArguments& a, const std::function<int()>& begin,
                    const std::function<int()>& resume) {
  if (a.resumed.empty()) {
    if (a.case_file.empty())
      throw InputError("found no case, expected a case file, or --resume FOLDER");
    return begin();
  }
  if (!simulation::tidy_if_finished(a.resumed) || !a.overrides.empty()) return resume();
  if (!a.quiet) print_out("{}: the run is complete, nothing to do\n", a.resumed);
  return 0;
}

fs::path result_folder(const ResultArguments& a, const std::string& suffix) {
  if (!a.folder.empty()) return a.folder;
  return fs::path("results") / (fs::path(a.case_file).stem().string() + suffix);
}

Overwrite overwrite_of(bool force) { return force ? Overwrite::force : Overwrite::no; }

void print_warning(const std::string& text) { fmt::print(stderr, "tdbd: warning: {}\n", text); }

void print_warnings(const std::vector<simulation::CaseWarning>& warnings) {
  for (const simulation::CaseWarning& w : warnings) print_warning(simulation::with_place(w));
}

double option_quantity(const std::string& option, const std::string& text,
                       const std::string& si_unit, const Range& range, const std::string& what) {
  try {
    if (const double value = to_si(text, si_unit); range.contains(value)) return value;
  } catch (const UnitError&) {  // reported below, with the expected value
  }
  throw InputError(fmt::format("{}: found '{}', expected {} {} with its unit", option, text, what,
                               range.text().substr(2)));
}

}  // namespace tdbd::app
