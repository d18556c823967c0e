#include "simulation/chain/chain_run.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/whole_file.hpp"
#include "simulation/chain/chain_history.hpp"
#include "simulation/result/figures.hpp"

namespace tdbd::simulation {
namespace {

/// Steps between checks of the clock, of an interruption and of the progress.
constexpr long longest_block = 1024;

long until_next(long every, long done) { return every - done % every; }

long next_steps(const ChainCase& c, long done) {
  const long profile =
      c.output.profile_every > 0 ? until_next(c.output.profile_every, done) : longest_block;
  return std::min({longest_block, until_next(c.history_every, done), profile, c.time.steps - done});
}

/// The steps of a chain, for run_loop.
class ChainSteps {
 public:
  ChainSteps(const ChainCase& c, ChainSimulation& s) : c_(c), s_(s) {}

  long done() const { return s_.steps_done; }
  long all() const { return c_.time.steps; }
  double time() const { return s_.time; }
  void prepare() {}
  long advance() {
    const long steps = next_steps(c_, done());
    advance_chain(c_, s_, steps);
    return steps;
  }
  void finish() {}
  template <class Progress>
  void report(const Progress& progress) const {
    progress(done(), all());
  }

 private:
  const ChainCase& c_;
  ChainSimulation& s_;
};

class ChainRecorder {
 public:
  ChainRecorder(const ChainCase& c, const ChainSimulation& s, const OutputFolder& folder)
      : c_(c), s_(s), history_(folder.path, c) {}

  void begin() { record(); }
  void record() { history_.append(c_, s_); }
  void close(RunStatus) { history_.close(); }
  void keep_so_far(const std::exception&) {
    ignore_failure([&] { history_.close(); });
  }

 private:
  const ChainCase& c_;
  const ChainSimulation& s_;
  ChainHistory history_;
};

struct ChainTask {
  ChainTask(const ChainCase& of, ChainSimulation& started, const OutputFolder& folder)
      : c(of), s(started), steps(c, s), recorder(c, s, folder) {}

  std::string summary(RunStatus status) const { return summary_json(c, s, status); }

  const ChainCase& c;
  ChainSimulation& s;
  ChainSteps steps;
  ChainRecorder recorder;
};

}  // namespace

ChainOutcome run_chain(const ChainCase& c, const RotateOptions& o) {
  const OutputFolder folder = claim(o.folder, o.overwrite, c.files, ResultKind::chain);
  ChainOutcome outcome{RunStatus::completed, start_chain(c)};
  clear(folder, c.files, ResultKind::chain);
  write_text(folder.path / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  write_static_tables(folder.path, c);
  if (c.time.steps > 0) {
    ChainTask task(c, outcome.end, folder);
    outcome.status = complete(task, folder, o);
  } else {
    if (o.started) o.started();
    write_text(folder.summary(), summary_json(c, outcome.end, outcome.status));
  }
  return outcome;
}

namespace {

using Json = nlohmann::ordered_json;

StringFigures figures_of(const ChainCase& c, const ChainSimulation& s) {
  const string::Elements& e = c.plan.chain.elements;
  return {e.length * c.plan.chain.count(),
          e.length,
          c.plan.chain.count(),
          static_loads(c.plan),
          chain_modes(c.plan),
          c.plan.longest_step,
          courant_numbers(c.plan.string.sections, e.length, c.time.step),
          node_rest_share(c.plan.chain, s.figures.node_steps_at_rest, s.steps_done)};
}

Json energy_json(const ChainCase& c, const ChainSimulation& s) {
  const string::ChainLedger& l = s.state.chain.ledger;
  const string::BitLedger& b = s.state.bit.ledger;
  const double stored =
      string::stored_energy(c.plan.chain, s.state.chain, string::motion_of(s.state.bit)) +
      string::stored_energy(c.plan.bit, s.state.bit);
  return {{"stored_j", stored},
          {"top_j", l.top},
          {"gravity_j", l.gravity + b.gravity},
          {"string_friction_j", l.friction},
          {"string_damping_j", l.damping},
          {"string_loss_j", l.loss + b.loss},
          {"top_damping_j", l.top_damping},
          {"bit_cut_j", b.cut},
          {"bit_friction_j", b.friction},
          {"bit_damping_j", b.damping},
          {"residual_max_j", s.figures.residual}};
}

Json run_json(const ChainCase& c, const ChainSimulation& s, const StringFigures& figures) {
  const ChainFigures& f = s.figures;
  const double half = std::max(1.0, 0.5 * static_cast<double>(s.steps_done));
  const string::SurfaceLoad surface = string::surface_load(c.plan.chain, s.state.chain, s.work);
  const string::EndLoad bit = string::bit_load(c.plan.bit, s.state.bit, string::end_load(s.work));
  Json json{{"steps", s.steps_done}, {"step_s", c.time.step}, {"duration_s", s.time}};
  json.update(steps_json(figures));
  json.update(Json{{"second_half",
                    {{"bit_speed_min_rad_s", f.least_speed},
                     {"bit_speed_max_rad_s", f.largest_speed},
                     {"bit_rest_share", static_cast<double>(f.bit_steps_at_rest) / half}}},
                   {"end",
                    {{"hook_load_n", surface.hook_load},
                     {"surface_torque_n_m", surface.torque},
                     {"weight_on_bit_n", bit.pull},
                     {"torque_on_bit_n_m", bit.torque},
                     {"bit_rate_m_s", s.state.bit.velocity},
                     {"bit_speed_rad_s", s.state.bit.rotary_speed}}},
                   {"energy", energy_json(c, s)}});
  return json;
}

}  // namespace

std::string summary_json(const ChainCase& c, const ChainSimulation& s, RunStatus status) {
  Json json = summary_head("string", c.title, status, c.hash, 0);
  Json warnings = Json::array();
  for (const CaseWarning& w : c.warnings) warnings.push_back(without_place(w));
  const StringFigures figures = figures_of(c, s);
  json["warnings"] = warnings;
  json.update(statics_json(figures));
  if (c.time.steps > 0) json.update(run_json(c, s, figures));
  return json.dump(2) + "\n";
}

}  // namespace tdbd::simulation
