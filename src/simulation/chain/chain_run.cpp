#include "simulation/chain/chain_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "io/whole_file.hpp"
#include "simulation/case/rotate_settings.hpp"
#include "simulation/case/run_settings.hpp"
#include "simulation/chain/chain_history.hpp"
#include "simulation/result/figures.hpp"

namespace tdbd::simulation {
namespace {

/// Frequency at which the blades of a regenerative bit pass a point, Hz; 0 for other bits.
double passing_frequency(const ChainPlan& p) {
  return p.bit.pitch > 0.0 ? p.rotary_speed / p.bit.pitch : 0.0;
}

}  // namespace

std::vector<DepthLoad> loads_by_depth(const ChainPlan& plan) {
  constexpr int depths = 50;
  const double length = plan.chain.elements.length * plan.chain.count();
  std::vector<DepthLoad> loads;
  for (int k = 1; k <= depths; ++k) {
    const double depth = length * k / depths;
    ChainPlan p = plan;
    p.string.sections.clear();
    for (const string::Span& s :
         string::spans_between(plan.string.sections, length - depth, length)) {
      p.string.sections.push_back(*s.section);
      p.string.sections.back().length = s.bottom - s.top;
    }
    const int count = std::max(2, plan.chain.count() * k / depths);
    p.chain.elements = string::make_elements(p.string.sections, count);
    p.chain.contact =
        string::make_contact(p.string.sections, p.string.survey, p.string.friction, count);
    p.bit.gravity_force = p.chain.contact.weight.back() +
                          plan.bit_weight * string::tangent_at(p.string.survey, depth).z();
    p.motion = {0.0, 0.0, p.bit.gravity_force, 0.0};
    DepthLoad here{depth};
    for (const StaticLoad& l : static_loads(p)) {
      const string::SurfaceLoad& surface = l.load.surface;
      if (l.name == "pull_up") here.pull_up = surface.hook_load;
      if (l.name == "slack_off") here.slack_off = surface.hook_load;
      if (l.name == "rotate") here.rotate = surface.hook_load;
      if (l.name == "rotate") here.torque = surface.torque;
    }
    loads.push_back(here);
  }
  return loads;
}

ChainCase read_chain_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  ChainCase r;
  r.path = path;
  TitleSettings title;
  read_fields(c, title);
  r.title = title.title;
  if (c.has(RotateTimeSettings::table)) r.time = read_rotate_time(c);
  r.plan = read_chain_plan(c, r.time.step, r.warnings);
  check_rig_log(c, r.plan.log, r.time.step * static_cast<double>(r.time.steps));
  r.history_every = read_table(c, StringOutput{usual_history_every(r.time.steps)}).history_every;
  Config output = c.table(StringOutput::table);
  r.output = read_chain_output(output, r.plan.chain, r.time.step);
  c.finish();
  add_number_doubts(c, r.warnings);
  std::ranges::move(chain_warnings(c, {r.plan.string, r.plan.chain, static_loads(r.plan),
                                       r.plan.string.hole_diameter, passing_frequency(r.plan)}),
                    std::back_inserter(r.warnings));
  r.files = c.files();
  r.resolved = c.resolved();
  r.hash = fnv1a_hex(c.fingerprint());
  return r;
}

namespace {

void watch(const ChainCase& c, ChainSimulation& s) {
  ChainFigures& f = s.figures;
  f.node_steps_at_rest += s.work.resting;
  if (2 * s.steps_done < c.time.steps) return;
  const double speed = s.state.bit.rotary_speed;
  const bool first = 2 * s.steps_done < c.time.steps + 2 && f.bit_steps_at_rest == 0 &&
                     f.least_speed == 0.0 && f.largest_speed == 0.0;
  f.least_speed = first ? speed : std::min(f.least_speed, speed);
  f.largest_speed = first ? speed : std::max(f.largest_speed, speed);
  f.bit_steps_at_rest += speed == 0.0;
}

double balance(const ChainCase& c, const ChainSimulation& s) {
  return string::energy_balance(c.plan.chain, c.plan.bit, s.state);
}

}  // namespace

ChainSimulation start_chain(const ChainCase& c) {
  const ChainPlan& p = c.plan;
  const string::SteadyLoad load = string::steady_load(p.chain, p.motion);
  string::SteadyStart start = string::steady_start(p.chain, p.motion, load);
  ChainSimulation s;
  s.state.chain = std::move(start.chain);
  s.state.bit.displacement = start.end.displacement;
  s.state.bit.angle = start.end.angle;
  if (p.bit.law != string::BitLaw::fixed) {
    s.state.bit.velocity = start.end.velocity;
    s.state.bit.rotary_speed = p.motion.rotary_speed;
  }
  if (p.bit.law == string::BitLaw::regenerative) {
    const double speed = p.rotary_speed;
    string::start_cut(p.bit, speed > 0.0 ? p.rate * p.bit.pitch / speed : 0.0, s.state.bit);
  }
  s.work = string::chain_work(p.chain, s.state.chain, string::motion_of(s.state.bit));
  s.figures.start_balance = balance(c, s);
  return s;
}

void advance_chain(const ChainCase& c, ChainSimulation& s, long steps) {
  const ChainPlan& p = c.plan;
  const double h = c.time.step;
  const string::TopCommand usual{p.rotary_speed * h, p.rate * h, p.hook_load, p.surface_weight};
  for (long i = 0; i < steps; ++i) {
    const string::TopCommand command =
        command_of(p.log, usual, h * static_cast<double>(s.steps_done), h);
    string::step_bit_on_chain(p.chain, p.bit, h, command, s.state, s.work);
    ++s.steps_done;
    watch(c, s);
  }
  s.time = h * static_cast<double>(s.steps_done);  // avoids a sum of rounded steps
  const double change = balance(c, s) - s.figures.start_balance;
  if (!std::isfinite(change))
    throw RunError("the state is no longer finite: the step is too long for this string");
  s.figures.residual = std::max(s.figures.residual, std::abs(change));
}

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
  static constexpr ResultKind kind = ResultKind::chain;

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

StringSummary summarize(const ChainCase& c, const ChainSimulation& s) {
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

Json run_json(const ChainCase& c, const ChainSimulation& s, const StringSummary& figures) {
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
  const Json warnings = texts_of_result(c.warnings);
  const StringSummary figures = summarize(c, s);
  json["warnings"] = warnings;
  json.update(statics_json(figures));
  if (c.time.steps > 0) json.update(run_json(c, s, figures));
  return json.dump(2) + "\n";
}

}  // namespace tdbd::simulation
