#include "simulation/result/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "bit/mass_properties.hpp"
#include "bit/report/bit_output.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/reason.hpp"
#include "core/whole_file.hpp"
#include "mesh/measures.hpp"
#include "simulation/checkpoint/checkpoint.hpp"
#include "simulation/result/checkpoint_keeper.hpp"
#include "simulation/result/end_warnings.hpp"
#include "simulation/result/frames.hpp"
#include "simulation/result/run_rows.hpp"
#include "simulation/result/wear_figures.hpp"
#include "simulation/start/reach.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/wear_step.hpp"

namespace tdbd::simulation {
namespace {

/// The resolved force law of every part, for bit.json; empty if the run computes no forces.
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

std::vector<PartVolumes> part_volumes(const Case& c, const VolumeLedger& l) {
  std::vector<PartVolumes> parts;
  for (std::size_t i = 0; i < c.bit.parts.size(); ++i) {
    PartVolumes p{c.bit.parts[i].name, l.removed_by_part[i].value(), {}};
    for (const auto& revolution : l.removed_by_revolution) p.by_revolution.push_back(revolution[i]);
    parts.push_back(std::move(p));
  }
  return parts;
}

std::map<std::string, long> maintenance_counts(const rock::MaintenanceReport& r) {
  const auto counts = rock::counts(r);
  return {counts.begin(), counts.end()};
}

/// What studies divide, by dotted key, SI. The step is the one that is used.
std::map<std::string, double> sizes_of(const Case& c) {
  std::map<std::string, double> sizes = c.quantities;
  sizes["time.step"] = c.time.step;
  return sizes;
}

Figures studied_figures_of(const RunSummary& r) {
  Figures figures{{"wob_mean_n", r.loads->wob.mean},
                  {"tob_mean_n_m", r.loads->tob.mean},
                  {"rop_mean_m_per_s", r.loads->rop.mean},
                  {"rotary_speed_mean_rad_per_s", r.loads->rotary_speed.mean}};
  if (!r.drive) return figures;
  figures["stick_slip_severity"] = r.diagnosis.stick_slip_severity;
  figures["torsional_frequency_hz"] = r.diagnosis.torsional_frequency;
  figures["orbit_radius_m"] = r.diagnosis.orbit_radius;
  figures["orbit_frequency_hz"] = r.diagnosis.orbit_frequency;
  return figures;
}

void add_drive(const Case& c, const Simulation& s, RunSummary& r) {
  const dynamics::DrillingSystem& system = case_now(c, s.work).drilling.system;
  r.diagnosis = diagnose(s.statistics.trace, s.statistics.loads.tob.mean);
  std::map<std::string, double> by_part;
  for (std::size_t i = 0; i < s.statistics.energy_by_part.size(); ++i)
    if (s.statistics.energy_by_part[i] != 0.0)
      by_part[c.bit.parts[i].name] = s.statistics.energy_by_part[i];
  r.drive = {dynamics::stored_energy(system, s.work.drive.at, s.state.drive->state),
             s.state.drive->ledger,
             by_part,
             expected_of(system, r.loads->rotary_speed.mean),
             {},
             s.statistics.standing};
  if (!system.chained) return;
  const string::Chain& chain = system.chained->chain;
  const string::Elements& e = chain.elements;
  const double inertia = system.gyrostat.inertia_B(2, 2);
  r.string = {e.length * chain.count(),
              e.length,
              chain.count(),
              static_loads(chain, system.mass * system.gravity, c.drilling.start_motion),
              chain_modes(chain, system.mass, inertia),
              string::longest_step(chain, system.mass, inertia),
              courant_numbers(c.drilling.string.sections, e.length, c.time.step),
              node_rest_share(chain, s.statistics.node_steps_at_rest, s.state.steps_done)};
}

/// What a run writes on its way.
struct Recorder {
  OutputFolder folder;
  History history;
  std::optional<ChainProfiles> profiles;  ///< of a string on a chain
  Frames frames;
  CheckpointKeeper keeper;
  std::vector<double> step_seconds;
  EnergyOrderPlan order_plan;
  EnergyOrder order;

  Recorder(const Case& c, const OutputFolder& f, const RunOptions& o)
      : folder(f),
        history(f.history(), history_parts(c.bit), history_extent(c), rows_of(c)),
        frames(f),
        keeper(f, c.output.checkpoint_every, o.warn),
        order_plan(plan_energy_order(c)) {
    if (c.output.chain.profile_every > 0)
      profiles.emplace(f.profiles(), c.drilling.system.chained->chain);
    order.residual.reason =
        order_plan.at < 0 ? order_plan.reason : "the run ended before its window";
  }
};

/// Puts the recorder where it was.
void go_on(const WrittenSoFar& written, Recorder& r) {
  r.keeper.begin_rows(r.history.width(), written.rows);
  if (RowLog* rows = r.keeper.rows())
    rows->replay([&](std::span<const double> row) { r.history.append_again(row); });
  r.history.set_window(written.window);
  if (r.profiles) {
    r.keeper.begin_rows(r.profiles->width(), written.profile_rows, RowsOf::profiles);
    if (RowLog* rows = r.keeper.rows(RowsOf::profiles))
      rows->replay([&](std::span<const double> row) { r.profiles->append_again(row); });
  }
  r.frames.set_frames(written.rock_frames, written.bit_frames);
  if (!written.order.residual.reason.empty() || written.order.residual.order)
    r.order = written.order;
}

void keep_checkpoint(const Case& c, const Simulation& s, Recorder& r) {
  const RowLog* rows = r.keeper.rows();
  if (rows == nullptr) return;
  const RowLog* profiles = r.keeper.rows(RowsOf::profiles);
  const WrittenSoFar written{rows->rows(),
                             r.history.window(),
                             r.frames.rock_frames(),
                             r.frames.bit_frames(),
                             r.order,
                             profiles != nullptr ? profiles->rows() : 0};
  r.keeper.keep([&](const std::filesystem::path& file) { write_checkpoint(file, c, s, written); });
}

/// A row every so many steps, and one of what is left at the end.
void record_step(const Case& c, const Simulation& s, Recorder& r) {
  take_step(c, s, r.history);
  const bool is_row = s.state.steps_done % c.output.history_every == 0;
  if ((is_row || s.state.steps_done == c.time.steps) && r.history.write())
    r.keeper.append(r.history.last_row());
}

/// A profile of the string every so many steps, the start's included.
void record_profile(const Case& c, const Simulation& s, Recorder& r) {
  if (!r.profiles || s.state.steps_done % c.output.chain.profile_every != 0) return;
  r.profiles->append(time_at(c.time, s.state.steps_done), chain_view(case_now(c, s.work), s));
  r.keeper.append(r.profiles->last_row(), RowsOf::profiles);
}

/// The loop over steps, with everything that is recorded on the way.
RunStatus loop(const Case& c, Simulation& s, const RunOptions& o, Recorder& r) {
  r.step_seconds.reserve(static_cast<std::size_t>(std::min(c.time.steps, 10'000'000L)));
  if (s.state.steps_done == 0) record_profile(c, s, r);
  while (s.state.steps_done < c.time.steps) {
    if (o.interrupted && *o.interrupted) return RunStatus::interrupted;
    if (s.state.steps_done == r.order_plan.at) r.order = observe_energy_order(c, s);
    const auto before = std::chrono::steady_clock::now();
    step(c, s);
    r.step_seconds.push_back(seconds_since(before));
    record_step(c, s, r);
    record_profile(c, s, r);
    if (c.output.frames_every > 0 && s.state.steps_done % c.output.frames_every == 0)
      r.frames.add(case_now(c, s.work), s);
    if (r.keeper.is_due(s.state.steps_done)) keep_checkpoint(c, s, r);
    if (o.progress) o.progress(s, c.time.steps);
  }
  wear_at_end(c, s);
  return RunStatus::completed;
}

void keep_so_far(const Case& c, const Simulation& s, const std::string& failure, Recorder& r) {
  ignore_failure([&] { r.history.close(); });
  if (r.profiles) ignore_failure([&] { r.profiles->close(); });
  ignore_failure([&] { r.frames.write_final(c, s); });
  ignore_failure([&] { write_text(r.folder.failure(), failure + "\n"); });
}

RunStatus run_steps(const Case& c, Simulation& s, const RunOptions& o, Recorder& r) {
  try {
    const RunStatus status = loop(c, s, o, r);
    if (status == RunStatus::interrupted) keep_checkpoint(c, s, r);
    r.history.close();
    if (r.profiles) r.profiles->close();
    r.frames.write_final(case_now(c, s.work), s);
    return status;
  } catch (const WearEnd& e) {
    ignore_failure([&] { keep_checkpoint(c, s, r); });
    const std::string failure = failure_text(s.state.steps_done, c.time.steps,
                                             time_at(c.time, s.state.steps_done), e.what());
    keep_so_far(case_now(c, s.work), s, failure, r);
    throw RunError(failure);
  } catch (const std::exception& e) {
    const std::string failure = failure_text(s.state.steps_done, c.time.steps,
                                             time_at(c.time, s.state.steps_done), reason_of(e));
    keep_so_far(c, s, failure, r);
    throw RunError(failure);
  }
}

}  // namespace

RunSummary summary_of(const Case& c, const Simulation& s, RunStatus status) {
  RunSummary r;
  r.command = "run";
  r.title = c.title;
  r.status = status;
  r.case_hash = c.hash;
  for (const CaseWarning& w : c.warnings) r.warnings.push_back(without_place(w));
  r.found_at_end = end_warnings(c, s);
  for (const CaseWarning& w : r.found_at_end) r.warnings.push_back(without_place(w));
  const double from = time_at(c.time, c.time.first), to = time_at(c.time, s.state.steps_done);
  r.steps = s.state.steps_done - c.time.first;
  r.duration = to - from;
  r.revolutions = (s.state.place.turned - s.state.start_turned) / (2.0 * std::numbers::pi);
  r.removed_volume = s.state.ledger.removed.value();
  for (const auto& revolution : s.state.ledger.removed_by_revolution)
    r.removed_volume_by_revolution.push_back(
        std::accumulate(revolution.begin(), revolution.end(), 0.0));
  r.parts = part_volumes(c, s.state.ledger);
  r.volume_ledger_defect = ledger_defect(s);
  r.maintenance_volume = s.state.maintenance.volume_change;
  r.trimmed_volume = s.state.ledger.trimmed.value();
  r.rock_triangles_start = s.state.start_triangles;
  r.rock_triangles_end = s.state.rock.surface.triangle_count();
  const mesh::QualityFigures quality = mesh::quality_figures(s.state.rock.surface);
  r.rock_quality_min = quality.least;
  r.rock_quality_1_percent = quality.one_percent;
  r.gage_radius = c.bit.gage_radius;
  r.maintenance = maintenance_counts(s.state.maintenance);
  r.faces = figures_of(c.bit, s.statistics.faces);
  if (c.forces.forces == Forces::on) {
    r.loads = figures_of(c.bit, s.statistics.loads, to);
    r.loads->uncertainty = sampling_of(s.statistics.trace);
  }
  if (s.state.drive) add_drive(c, s, r);
  if (r.loads && r.loads->steps > 0)
    for (const StudiedConvergence& study : c.output.convergence)
      r.numerical.push_back(numerical_uncertainty(study, sizes_of(c), studied_figures_of(r)));
  if (s.work.wear) r.wear = figures_of_wear(c, s);
  if (s.state.spalling)
    for (std::size_t i = 0; i < c.bit.cutters.size(); ++i)
      r.broken_out.emplace_back(cutter_name(c.bit.cutters[i]),
                                s.state.spalling->broken_out[i].value());
  r.sections_refused_deep = s.statistics.faces.refused_deep;
  r.sections_refused_over_the_top = s.statistics.faces.refused_over_the_top;
  for (std::size_t k = 0; k < s.state.cones.size(); ++k)
    r.cones.push_back(figures_of(c.bit.cones[k], s.state.cones[k], s.statistics.cones[k]));
  return r;
}

namespace {

/// Drills to the end and writes the figures, the summary last.
RunSummary finish(const Case& c, const RunOptions& o, Simulation& s, Recorder& r) {
  const auto started = std::chrono::steady_clock::now();
  if (o.started) o.started();
  RunSummary summary = summary_of(c, s, run_steps(c, s, o, r));
  if (summary.drive) summary.drive->order = r.order;
  const double wall = seconds_since(started);
  write_text(r.folder.timing(), to_json(timing_of(r.step_seconds, wall, o.threads)));
  write_text(r.folder.summary(), to_json(summary));
  if (summary.status == RunStatus::completed) r.keeper.remove();
  return summary;
}

/// The newest checkpoint; none: there is no file of one.
std::optional<Checkpoint> newest_checkpoint(const OutputFolder& folder, const Case& c,
                                            const CheckpointKeeper::Warn& warn) {
  std::optional<Checkpoint> saved;
  const auto read = [&](const std::filesystem::path& file) {
    return saved.emplace(read_checkpoint(file, c)).state.steps_done;
  };
  read_newest_checkpoint(folder, read, warn);
  return saved;
}

}  // namespace

RunSummary run(const Case& c, const RunOptions& o) {
  const ThreadLimit limit(o.threads);
  const OutputFolder folder = claim(o.folder, o.overwrite, c.files);
  Simulation s = start(c);
  clear(folder, c.files);
  if (o.tell)
    for (const CaseWarning& w : reach_warnings(c, s.state.rock.surface)) o.tell(w);
  write_text(folder.path / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  bit::write_bit_files(folder.path, c.bit, part_laws(c));
  Recorder recorder(c, folder, o);
  go_on({}, recorder);
  return finish(c, o, s, recorder);
}

RunSummary resume_run(const Case& c, const RunOptions& o) {
  const ThreadLimit limit(o.threads);
  const OutputFolder folder{o.folder, std::make_shared<FolderLock>(o.folder)};
  std::optional<Checkpoint> saved = newest_checkpoint(folder, c, o.warn);
  forget_end(folder);
  std::filesystem::create_directories(folder.frames());
  bit::write_bit_files(folder.path, c.bit, part_laws(c));
  Recorder recorder(c, folder, o);
  go_on(saved ? saved->written : WrittenSoFar{}, recorder);
  Simulation s =
      saved ? resume(c, std::move(saved->state), std::move(saved->statistics)) : start(c);
  return finish(c, o, s, recorder);
}

Case read_stopped_case(const std::filesystem::path& folder) {
  return read_case(stopped_case(folder, Stopped::run).string(), {});
}

}  // namespace tdbd::simulation
