#include "simulation/result/run.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "bit/cone/cone_bit.hpp"
#include "bit/report/bit_output.hpp"
#include "core/config/config.hpp"
#include "core/parallel.hpp"
#include "io/whole_file.hpp"
#include "mesh/files/ply.hpp"
#include "mesh/files/vtp.hpp"
#include "mesh/measures.hpp"
#include "simulation/case/rotate_settings.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/wear_step.hpp"

namespace tdbd::simulation {
namespace {

/// Writes point data (depth below the start of the bit in m, and the part that last cut a vertex)
/// and cell data (shape quality).
void write_rock(const std::filesystem::path& path, const rock::Rock& rock) {
  std::vector<int> slots;
  const mesh::TriangleMesh m = mesh::compact(rock.surface, &slots);
  mesh::Field depth{"depth_m", {}}, part{"last_part", {}, mesh::FieldValues::whole_numbers},
      quality{"quality", {}};
  for (const int v : slots) {
    depth.values.push_back(rock.surface.position(v).z());
    part.values.push_back(rock.last_part[at(v)]);
  }
  for (const auto& [a, b, c] : m.triangles)
    quality.values.push_back(
        mesh::triangle_quality(m.positions[at(a)], m.positions[at(b)], m.positions[at(c)]));
  mesh::write_vtp(path, m, {depth, part}, {quality});
}

/// Writes the rock with its stamp, from which a run that begins with this rock checks its start
/// time.
void write_stamped_rock(const std::filesystem::path& path, const Case& c, const Simulation& s) {
  const long steps = s.state.steps_done;
  AtomicFile file(path);
  mesh::write_ply(file.stream(), mesh::compact(s.state.rock.surface),
                  comments_of({steps, time_at(c.time, steps), c.hash}));
  file.commit();
}

void write_bit(const std::filesystem::path& path, const Case& c, const Simulation& s) {
  bit::write_bit_vtp(path, bit::turned(c.bit, angles_of(s.state.cones)), s.state.place.X_WB);
}

bit::BodyPoses poses_of(const Case& c, const Simulation& s) {
  return bit::body_poses(c.bit, s.state.place.X_WB, angles_of(s.state.cones),
                         time_at(c.time, s.state.steps_done));
}

/// Builds the index, which is not stored, from the surface.
void rebuild(const Case& c, rock::Rock& rock) {
  mesh::refresh_stars(rock.surface);
  rock::Rock indexed = indexed_rock(c, std::move(rock.surface));
  rock.surface = std::move(indexed.surface);
  rock.grid = std::move(indexed.grid);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Case& c, const Simulation& s,
                      const WrittenSoFar& written) {
  tdbd::write_checkpoint(path, {c.hash, c.resolved}, s.state, s.statistics, written);
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const Case& c) {
  Checkpoint saved;
  tdbd::read_checkpoint(path, {c.hash, c.resolved}, saved.state, saved.statistics, saved.written);
  rebuild(c, saved.state.rock);
  return saved;
}

void Frames::add(const Case& c, const Simulation& s) {
  const auto rock = folder_.frame("rock", s.state.steps_done);
  write_rock(rock, s.state.rock);
  rock_.emplace_back(time_at(c.time, s.state.steps_done), "frames/" + rock.filename().string());
  bit_.push_back(poses_of(c, s));
}

void Frames::write_final(const Case& c, const Simulation& s) {
  write_rock(folder_.frames() / "rock_final.vtp", s.state.rock);
  write_stamped_rock(folder_.path / "rock_final.ply", c, s);
  write_bit(folder_.frames() / "bit_final.vtp", c, s);
  write_collection("rock", rock_, time_at(c.time, s.state.steps_done));
  write_collection("bit", {}, time_at(c.time, s.state.steps_done));
  write_motion(c, s);
}

/// Writes an animation only for more than one pose: of a single pose the mesh is sufficient.
void Frames::write_motion(const Case& c, const Simulation& s) const {
  std::vector<bit::BodyPoses> frames = bit_;
  const bit::BodyPoses end = poses_of(c, s);
  if (!frames.empty() && frames.back().time == end.time) frames.pop_back();
  frames.push_back(end);
  bit::write_bit_poses(folder_.path / "bit_poses.csv", c.bit, frames);
  if (frames.size() > 1) bit::write_bit_animation(folder_.path / "bit.glb", c.bit, frames);
}

void Frames::write_collection(const std::string& name, FrameList frames, double end) const {
  if (!frames.empty() && frames.back().first == end) frames.pop_back();  // one frame per time
  frames.emplace_back(end, "frames/" + name + "_final.vtp");
  mesh::write_pvd(folder_.path / (name + ".pvd"), frames);
}

DrillingRecorder::DrillingRecorder(const Case& c, const Simulation& s, EnergyOrder& order,
                                   const OutputFolder& folder, const CheckpointKeeper::Warn& warn)
    : c_(c),
      s_(s),
      order_(order),
      history_(folder.history(), history_parts(c.bit), history_extent(c), rows_of(c)),
      frames_(folder),
      keeper_(folder, c.output.checkpoint_every, warn) {
  if (c.output.chain.profile_every > 0)
    profiles_.emplace(folder.profiles(), c.drilling.system.chained->chain);
}

void DrillingRecorder::restore(const WrittenSoFar& written) {
  const auto replay = [&](auto& record, RowsOf of, long kept) {
    keeper_.begin_rows(record.width(), kept, of);
    if (RowLog* rows = keeper_.rows(of))
      rows->replay([&](std::span<const double> row) { record.append_again(row); });
  };
  replay(history_, RowsOf::history, written.rows);
  history_.set_window(written.window);
  if (profiles_) replay(*profiles_, RowsOf::profiles, written.profile_rows);
  frames_.set_frames(written.rock_frames, written.bit_frames);
  if (!written.order.residual.reason.empty() || written.order.residual.order)
    order_ = written.order;
}

void DrillingRecorder::write_row() {
  if (history_.write()) keeper_.append(history_.last_row());
}

/// Writes a row of the history at the given interval. The row of the remaining steps at the end is
/// written after the last checkpoint, because a run with a later end does not have it.
void DrillingRecorder::record() {
  const long steps = s_.state.steps_done;
  take_step(c_, s_, history_);
  if (steps % c_.output.history_every == 0) write_row();
  record_profile();
  if (c_.output.frames_every > 0 && steps % c_.output.frames_every == 0)
    frames_.add(case_now(c_, s_.work), s_);
  if (steps == c_.time.steps || keeper_.is_due(steps)) keep_checkpoint();
}

/// Writes a profile of the string at the given interval, including the start.
void DrillingRecorder::record_profile() {
  if (!profiles_ || s_.state.steps_done % c_.output.chain.profile_every != 0) return;
  profiles_->append(time_at(c_.time, s_.state.steps_done), chain_view(case_now(c_, s_.work), s_));
  keeper_.append(profiles_->last_row(), RowsOf::profiles);
}

void DrillingRecorder::keep_checkpoint() {
  const RowLog* rows = keeper_.rows();
  if (rows == nullptr) return;
  const RowLog* profiles = keeper_.rows(RowsOf::profiles);
  const WrittenSoFar written{rows->rows(),
                             history_.window(),
                             frames_.rock_frames(),
                             frames_.bit_frames(),
                             order_,
                             profiles != nullptr ? profiles->rows() : 0};
  keeper_.keep([&](const std::filesystem::path& file) { write_checkpoint(file, c_, s_, written); });
}

void DrillingRecorder::close(RunStatus status) {
  if (status == RunStatus::interrupted)
    keep_checkpoint();
  else
    write_row();
  history_.close();
  if (profiles_) profiles_->close();
  frames_.write_final(case_now(c_, s_.work), s_);
}

void DrillingRecorder::keep_so_far(const std::exception& failure) {
  const bool worn_out = dynamic_cast<const WearEnd*>(&failure) != nullptr;
  if (worn_out) ignore_failure([&] { keep_checkpoint(); });
  ignore_failure([&] { history_.close(); });
  if (profiles_) ignore_failure([&] { profiles_->close(); });
  ignore_failure([&] { frames_.write_final(worn_out ? case_now(c_, s_.work) : c_, s_); });
}

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
