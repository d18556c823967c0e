#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "reference/compare/compare_tables.hpp"
#include "reference/compare/comparison_files.hpp"

namespace {

using namespace tdbd::reference;

constexpr const char* keys_head =
    "# The keys of [compare]\n"
    "\n"
    "`tdbd-compare --keys` writes this file from the declarations (`compare_keys.hpp`); do not "
    "edit "
    "it. All other keys of\n"
    "a case are those of `tdbd run` (`src/simulation/case/KEYS.md`).\n"
    "\n";

struct Arguments {
  std::string case_file, folder, models;
  std::vector<std::string> overrides;
  bool force = false, quiet = false, keys = false;
  int threads = 1;
};

/// The tables of keys. Replaces the subcommand name of tdbd, which key tables contain, by the name
/// of this program.
std::string keys_text() {
  std::string text = tdbd::keys_as_markdown(compare_tables());
  for (std::size_t at = 0; (at = text.find("tdbd compare", at)) != std::string::npos;)
    text.replace(at, 12, "tdbd-compare");
  return keys_head + text;
}

/// The names in "a,b", or those of the case.
std::vector<std::string> names_of(const Arguments& a, const CompareCase& c) {
  if (a.models.empty()) return c.options.models;
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= a.models.size();) {
    const std::size_t to = std::min(a.models.find(',', from), a.models.size());
    names.push_back(a.models.substr(from, to - from));
    from = to + 1;
  }
  return names;
}

std::filesystem::path folder_of(const Arguments& a) {
  if (!a.folder.empty()) return a.folder;
  return std::filesystem::path("results") /
         (std::filesystem::path(a.case_file).stem().string() + "-compared");
}

void print(const Comparison& all, const std::filesystem::path& folder) {
  fmt::print("models of one bit, not bits, are compared (two bits: tdbd compare A B)\n");
  fmt::print("{}", comparison_table(all));
  for (const Answer& answer : all.answers)
    for (const std::string& note : answer.findings.notes)
      fmt::print("{}: {}\n", answer.model->title, note);
  for (const std::string& why : all.excluded_models) fmt::print("not asked: {}\n", why);
  fmt::print("-: the model cannot say it; why: comparison.csv\nresults in {}\n", folder.string());
}

int compare_models(const Arguments& a) {
  const tdbd::ThreadLimit limit(a.threads);
  const CompareCase c = read_compare_case(a.case_file, a.overrides);
  const std::vector<std::string> names = names_of(a, c);
  const auto chosen = chosen_models(c, names);
  const bool any = std::find(names.begin(), names.end(), "all") != names.end();
  const std::filesystem::path folder = folder_of(a);
  const auto overwrite = a.force ? tdbd::Overwrite::force : tdbd::Overwrite::no;
  check_folder(folder, overwrite);
  const Comparison all =
      compare(c, chosen, any ? Refusal::is_noted : Refusal::stops, [&](const Model& m) {
        if (!a.quiet) fmt::print(stderr, "{} ...\n", m.title);
      });
  write_comparison(folder, c, all);
  if (!a.quiet) print(all, folder);
  return 0;
}

int run(const Arguments& a) {
  if (a.keys) {
    fmt::print("{}", keys_text());
    return 0;
  }
  if (a.case_file.empty()) throw tdbd::InputError("CASE: found nothing, expected a case file");
  return compare_models(a);
}

int guarded(const Arguments& a) {
  try {
    return run(a);
  } catch (const tdbd::InputError& e) {
    fmt::print(stderr, "tdbd-compare: {}\n", e.what());
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "tdbd-compare: out of memory\n");
    return 1;
  } catch (const std::exception& e) {
    fmt::print(stderr, "tdbd-compare: {}\n", e.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Compares models, not bits: one bit, one rock, one schedule through the models of chapter 2 "
      "and through TDBD (two bits: tdbd compare A B)");
  Arguments a;
  app.add_option("case", a.case_file, "a case of tdbd run, with a table [compare]");
  app.add_option("-o,--output", a.folder, "result folder; default results/CASE-compared");
  app.add_option("--models", a.models, "all, or names with commas: warren-sinor,behr,tdbd");
  app.add_option("--set", a.overrides, "override a key, as often as needed: --set time.step='2 ms'")
      ->allow_extra_args(false);
  app.add_option("--threads", a.threads, "threads of our run; the results do not depend on them")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_flag("--force", a.force, "replace the results in the folder");
  app.add_flag("--quiet", a.quiet, "no table");
  app.add_flag("--keys", a.keys, "list the keys of [compare], as Markdown");
  app.footer("Example: tdbd-compare cases/compare/bit-b.toml -o out/b --models all");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return guarded(a);
}
