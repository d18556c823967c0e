#include "sweep/point/run_point.hpp"

#include <fmt/format.h>

#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <utility>

#include "bit/files/bit_file.hpp"
#include "bit/report/bit_report.hpp"
#include "calibration/result/calibration_files.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/reason.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_run.hpp"
#include "simulation/rotate/rotate_summary.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/wear_step.hpp"
#include "sweep/point/figures.hpp"
#include "sweep/point/planar.hpp"

namespace tdbd::sweep {
namespace {

namespace sim = simulation;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

struct Summary {
  std::string case_hash, text;
};

void stop_if(bool interrupted) {
  if (interrupted) throw Interrupted{};
}

/// As `tdbd run` does it, without its files.
Summary drill(const Design& d, const Words& overrides, PointSurroundings& around) {
  const sim::Case c = read_case(d.case_file, overrides, around.starts);
  sim::Simulation s = start(c, around.starts, std::move(around.room));
  const sim::EnergyOrderPlan plan = sim::plan_energy_order(c);
  sim::EnergyOrder order;
  order.residual.reason = plan.at < 0 ? plan.reason : "the run ended before its window";
  while (s.state.steps_done < c.time.steps) {
    stop_if(around.interrupted != nullptr && *around.interrupted);
    if (s.state.steps_done == plan.at) order = sim::observe_energy_order(c, s);
    sim::step(c, s);
  }
  sim::wear_at_end(c, s);
  sim::RunSummary summary = sim::summary_of(c, s, sim::RunStatus::completed);
  if (summary.drive) summary.drive->order = order;
  around.room = std::move(s.work.cutting);
  return {c.hash, sim::to_json(summary)};
}

Summary rotate(const Design& d, const Words& overrides, const std::atomic<bool>* interrupted) {
  const sim::RotateCase c = sim::read_rotate_case(d.case_file, overrides);
  sim::RotateOptions options;
  options.interrupted = interrupted;
  sim::RotateSimulation s = sim::start(c);
  std::vector<double> step_seconds;
  const sim::RunStatus status = sim::rotate_steps(c, s, options, {}, step_seconds);
  stop_if(status == sim::RunStatus::interrupted);
  return {c.hash, sim::summary_json(c, s, status)};
}

/// Cut runs are files, and the library behind them knows no threads.
Summary fit(const Design& d, const Words& overrides, const std::filesystem::path& cuts) {
  static std::mutex turn;
  const std::lock_guard hold(turn);
  const auto c = calibration::read_calibration(d.case_file, overrides);
  std::filesystem::create_directories(cuts);
  const auto found = calibration::calibrate(c, calibration::find_cuts(c, cuts));
  const std::string text = calibration::to_json(c, found);
  return {fnv1a_hex(text), text};
}

Summary analyse(const Design& d, const Words& overrides) {
  const bit::BitFile read =
      bit::read_bit(d.case_file, bit::DirectionRule::hybrid, bit::InsideRule::down,
                    bit::Densities::required, overrides);
  bit::ReportOptions options;
  options.advance = d.penetration;
  return {fnv1a_hex(read.fingerprint), bit::analysis_json(read.bit, options)};
}

Summary judge(const Design& d, const Words& overrides) {
  const sim::Case c = sim::read_case(d.case_file, overrides);
  return {c.hash, planar_summary(c, d.normal_ratio).dump()};
}

Summary summary_of(const Design& d, const Words& overrides, PointSurroundings& around) {
  switch (d.command) {
    case Command::run:
      return drill(d, overrides, around);
    case Command::rotate:
      return rotate(d, overrides, around.interrupted);
    case Command::calibrate:
      return fit(d, overrides, around.cuts);
    case Command::planar:
      return judge(d, overrides);
    case Command::bit:
      break;
  }
  return analyse(d, overrides);
}

/// Messages name files from the design's folder, so that they are the same wherever that lies.
std::string from_folder(const Design& d, std::string message) {
  const std::string folder =
      (std::filesystem::absolute(d.file).lexically_normal().parent_path() / "").string();
  for (std::size_t at = message.find(folder); at != std::string::npos;
       at = message.find(folder, at))
    message.erase(at, folder.size());
  return message;
}

}  // namespace

PointOutcome run_point(const Design& d, const Words& overrides, PointSurroundings& around) {
  PointOutcome outcome;
  bool ended = false;
  try {
    const Summary summary = summary_of(d, overrides, around);
    ended = true;
    outcome.case_hash = summary.case_hash;
    outcome.figures = figures_of(Json::parse(summary.text), d.figures);
  } catch (const std::exception& e) {
    outcome.status = PointStatus::failed;
    outcome.lacks_figures = ended;
    outcome.message = from_folder(d, reason_of(e));
    outcome.figures.assign(d.figures.size(), std::numeric_limits<double>::quiet_NaN());
  }
  return outcome;
}

Words files_of(const Design& d, const Words& overrides) {
  switch (d.command) {
    case Command::run:
    case Command::planar:
      return sim::read_case(d.case_file, overrides).files;
    case Command::rotate:
      return sim::read_rotate_case(d.case_file, overrides).files;
    case Command::calibrate:
      return calibration::read_calibration(d.case_file, overrides).files;
    case Command::bit:
      break;
  }
  return bit::read_bit(d.case_file, bit::DirectionRule::hybrid, bit::InsideRule::down,
                       bit::Densities::as_given, overrides)
      .files;
}

Words figures_on_offer(const Design& d, const Words& overrides, const std::filesystem::path& cuts) {
  Starts starts(Keeping::off);
  PointSurroundings around{cuts, nullptr, starts};
  return figure_names(Json::parse(summary_of(d, overrides, around).text));
}

}  // namespace tdbd::sweep
