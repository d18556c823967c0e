#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "calibration/laboratory/laboratory_file.hpp"
#include "simulation/case/case_kind.hpp"

namespace tdbd::app {
namespace {

struct LaboratoryArguments {
  std::string case_file, output, cuts;
  std::vector<std::string> overrides;
  bool force = false;
  int threads = 1;
};

int make_records(const LaboratoryArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::laboratory});
  const auto c = calibration::read_laboratory(a.case_file, a.overrides);
  calibration::write_records(c, {a.output, a.cuts, overwrite_of(a.force), a.threads, {}});
  return 0;
}

}  // namespace

void add_laboratory(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("laboratory", "Compute synthetic records of bits under a known force law");
  auto a = std::make_shared<LaboratoryArguments>();
  command->add_option("case", a->case_file, "the laboratory (TOML)")
      ->required()
      ->type_name(a_toml_file);
  command->add_option("-o,--output", a->output, "the records, csv")
      ->required()
      ->type_name("FILE.csv");
  command->add_option("--cuts", a->cuts, "folder of cut runs; default: cuts, next to the records")
      ->type_name(a_folder);
  add_set(*command, a->overrides, "override a key: --set laboratory.seed=7");
  command->add_flag("--force", a->force, "replace the file");
  add_threads(*command, a->threads);
  command->footer(
      "The keys: tdbd keys laboratory.\n"
      "Example: tdbd laboratory validation/cases/laboratory.toml -o out/lab.csv");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return make_records(*a); }); });
}

}  // namespace tdbd::app
