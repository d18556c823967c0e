#include "simulation/result/run.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "bit/report/bit_output.hpp"
#include "core/config/config.hpp"
#include "core/parallel.hpp"
#include "simulation/case/rotate_settings.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/wear_step.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

std::string command_name(Stopped command) { return command == Stopped::run ? "run" : "rotate"; }

}  // namespace

fs::path stopped_case(const fs::path& folder, Stopped command) {
  const fs::path file = folder / "case.toml";
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line != resolved_head)
    throw InputError(
        fmt::format("{}: found no case.toml of a run, expected the folder of a run that "
                    "was stopped",
                    folder.string()));
  const bool rotates = Config::read_file(file.string(), {}).has(BodySettings::table);
  if (const Stopped found = rotates ? Stopped::rotate : Stopped::run; found != command)
    throw InputError(fmt::format(
        "{}: found a run of tdbd {}, expected one of tdbd {}; to resume it: tdbd {} --resume {}",
        folder.string(), command_name(found), command_name(command), command_name(found),
        folder.string()));
  return file;
}

bool tidy_if_finished(const fs::path& folder) {
  std::ifstream in(folder / "summary.json");
  const auto summary = nlohmann::json::parse(in, nullptr, false);
  const bool is_finished = summary.is_object() && summary.value("status", "") == "completed";
  if (is_finished)
    tidy({folder}, summary.value("command", "") == "run" ? ResultKind::run : ResultKind::rotate);
  return is_finished;
}

void tidy(const OutputFolder& folder, ResultKind kind) {
  if (kind == ResultKind::run)
    keep_newest_checkpoint(folder);
  else
    remove_checkpoints(folder);
}

namespace {

/// Returns the resolved force law of every part, for bit.json; empty if the run computes no forces.
std::vector<bit::PartLaw> part_laws(const Case& c) {
  std::vector<bit::PartLaw> laws;
  if (c.forces.forces == Forces::off) return laws;
  for (std::size_t i = 0; i < c.bit.parts.size(); ++i) {
    forces::Law law = law_of(c.forces, c.bit.parts[i].kind, static_cast<int>(i));
    bit::PartLaw& words = laws.emplace_back();
    words.law = forces::law_name(law);
    for (const forces::LawField& f : forces::law_fields(law))
      words.coefficients.emplace_back(std::string(f.key), *f.value);
    if (!c.forces.part_areas.empty()) words.areas = c.forces.part_areas[i];
  }
  return laws;
}

/// A run and its result folder, for run_case and resume_case.
struct DrillingTask {
  using Case = simulation::Case;
  using Options = RunOptions;
  using Outcome = RunSummary;
  using Saved = Checkpoint;
  using Written = WrittenSoFar;
  static constexpr ResultKind kind = ResultKind::run;

  static Simulation start(const Case& c) { return simulation::start(c); }
  static Simulation resume(const Case& c, Checkpoint saved) {
    return simulation::resume(c, std::move(saved.state), std::move(saved.statistics));
  }
  static Checkpoint read(const std::filesystem::path& file, const Case& c) {
    return read_checkpoint(file, c);
  }

  DrillingTask(const Case& of, Simulation started, const OutputFolder& folder, const Options& o)
      : c(of),
        s(std::move(started)),
        steps(c, s, plan_energy_order(c)),
        recorder(c, s, steps.order, folder, o.warn) {
    std::filesystem::create_directories(folder.frames());
    bit::write_bit_files(folder.path, c.bit, part_laws(c));
  }

  void announce(const Options& o) const {
    if (!o.tell) return;
    for (const CaseWarning& w : reach_warnings(c, s.state.rock.surface)) o.tell(w);
  }
  std::string summary(RunStatus status) {
    figures = summary_of(c, s, status);
    if (figures.drive) figures.drive->order = steps.order;
    return to_json(figures);
  }
  RunSummary outcome(RunStatus) { return std::move(figures); }

  const Case& c;
  Simulation s;
  DrillingSteps steps;
  DrillingRecorder recorder;
  RunSummary figures;
};

}  // namespace

DrillingSteps::DrillingSteps(const Case& c, Simulation& s, const EnergyOrderPlan& plan)
    : c_(c), s_(s), observe_at_(plan.at) {
  order.residual.reason = plan.at < 0 ? plan.reason : "the run ended before its window";
}

void DrillingSteps::prepare() {
  if (done() == observe_at_) order = observe_energy_order(c_, s_);
}

long DrillingSteps::advance() {
  step(c_, s_);
  return 1;
}

void DrillingSteps::finish() { wear_at_end(c_, s_); }

RunSummary run(const Case& c, const RunOptions& o) {
  const ThreadLimit limit(o.threads);
  return run_case<DrillingTask>(c, o);
}

RunSummary resume_run(const Case& c, const RunOptions& o) {
  const ThreadLimit limit(o.threads);
  return resume_case<DrillingTask>(c, o);
}

Case read_stopped_case(const std::filesystem::path& folder) {
  return read_case(stopped_case(folder, Stopped::run).string(), {});
}

}  // namespace tdbd::simulation
