#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/case_kind.hpp"
#include "app/commands.hpp"
#include "calibration/laboratory/laboratory.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/whole_file.hpp"

namespace tdbd::app {
namespace {

struct LaboratoryArguments {
  std::string case_file, output, cuts;
  std::vector<std::string> overrides;
  bool force = false;
  int threads = 1;
};

/// Throws InputError where the records may not be written.
void demand_free(const std::filesystem::path& file, const LaboratoryArguments& a,
                 const std::vector<std::string>& inputs) {
  if (!std::filesystem::exists(file)) return;
  for (const std::string& input : inputs)
    if (std::filesystem::equivalent(file, input))
      throw InputError(file.string() + ": found an input itself, expected another file to write");
  if (!a.force) throw InputError(fmt::format("{}: exists; --force overwrites", file.string()));
}

int make_records(const LaboratoryArguments& a) {
  require_kind(a.case_file, a.overrides, {CaseKind::laboratory});
  const ThreadLimit limit(a.threads);
  const auto c = calibration::read_laboratory(a.case_file, a.overrides);
  const std::filesystem::path file = std::filesystem::absolute(a.output).lexically_normal();
  demand_free(file, a, c.setup.files);
  const std::filesystem::path cuts =
      a.cuts.empty() ? file.parent_path() / "cuts" : std::filesystem::path(a.cuts);
  const auto store = calibration::find_cuts(c.setup, cuts);
  std::filesystem::create_directories(file.parent_path());
  write_text(file, calibration::records_csv(calibration::drill(c, store)));
  return 0;
}

}  // namespace

void add_laboratory(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("laboratory", "Make synthetic records of bits under a known force law");
  auto a = std::make_shared<LaboratoryArguments>();
  command->add_option("case", a->case_file, "the laboratory (TOML)")->required();
  command->add_option("-o,--output", a->output, "the records, csv")->required();
  command->add_option("--cuts", a->cuts, "folder of cut runs; default: cuts, beside the records");
  add_set(*command, a->overrides, "override a key: --set laboratory.seed=7");
  command->add_flag("--force", a->force, "replace the file");
  add_threads(*command, a->threads);
  command->footer(
      "The keys: tdbd keys laboratory.\n"
      "Example: tdbd laboratory validation/cases/laboratory.toml -o out/lab.csv");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return make_records(*a); }); });
}

}  // namespace tdbd::app
