#include "simulation/case/read_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "string/statics.hpp"

namespace tdbd::simulation {
namespace {

using string::BitLaw;
using string::Top;

/// The speed of the fastest waves in the sections, m/s.
double fastest_wave(const std::vector<string::Section>& sections) {
  double fastest = 0.0;
  for (const string::Section& s : sections) {
    if (s.mass > 0.0) fastest = std::max(fastest, string::axial_wave_speed(s));
    if (s.inertia > 0.0) fastest = std::max(fastest, string::torsional_wave_speed(s));
  }
  return fastest;
}

/// Elements of about the given length, at least two if the string has mass.
int element_count(Config& c, const StringPlan& p, double step) {
  constexpr double usual = 10.0, courant = 0.9, most = 1e5;
  const double length = string::total_length(p.sections), wave = fastest_wave(p.sections);
  ChainElements e{std::min(std::max(usual, wave * step / courant), length)};
  read_fields(c, e);
  const double wanted = e.element_length;
  const double count = std::round(length / wanted);
  if (count <= most) return std::max(1, static_cast<int>(count));
  c.problem("element_length", fmt::format("{:.6g} m, which makes {:.0f} elements", wanted, count),
            fmt::format("at most {:.0f} elements", most));
  return 1;
}

void refuse(Config& c, std::string_view key, const std::string& found,
            const std::string& expected) {
  if (c.has(key)) c.problem(key, found, expected);
}

/// Reads the top drive. `frequency`: the default of its tuned frequency, Hz.
Top read_top(Config& c, double impedance, double frequency) {
  TopSettings s;
  s.tuned_frequency = frequency;
  read_fields(c, s);
  Top top = s.top;
  if (s.torsion != TopDrive::speed) top.torsion = Top::Torsion::pi;
  if (s.torsion == TopDrive::soft_torque)
    string::tune_soft_torque(top, impedance, s.impedance_factor, s.tuned_frequency);
  if (s.torsion == TopDrive::z_torque)
    string::tune_z_torque(top, impedance, s.impedance_factor, s.compensation);
  if (top.axial != Top::Axial::autodriller) return top;
  const std::vector<double>& limits = s.rate_limits;
  if (limits.size() != 2 || !(limits[0] < limits[1])) {
    c.problem("rate_limits", "no two ascending rates", "the slowest and the fastest rate");
    return top;
  }
  top.least_rate = limits[0];
  top.largest_rate = limits[1];
  return top;
}

void read_simple_bit(Config& string, string::SimpleBit& b) {
  b = read_table(string, SimpleBitSettings{b}).bit;
  if (b.sliding_torque > b.resting_torque)
    string.table(SimpleBitSettings::table)
        .problem("dynamic", fmt::format("{:.6g} N m", b.sliding_torque),
                 fmt::format("at most the torque at rest, {:.6g} N m", b.resting_torque));
}

/// The weight (N) and torque (N m) of the bit at the start.
struct StartLoad {
  double weight = 0.0, torque = 0.0;
};

StartLoad load_of_law(const string::SimpleBit& b, double rate, double speed) {
  StartLoad l{b.weight + b.axial_damping * rate, b.torque + b.torsional_damping * speed};
  if (b.law == BitLaw::two_level) l.torque += b.sliding_torque;
  if (b.law == BitLaw::regenerative && speed > 0.0) {
    const double cut = rate * b.pitch / speed;
    l.weight += b.force_per_depth * cut + b.contact_force;
    l.torque += b.torque_per_depth * cut + b.contact_lever * b.contact_force;
  }
  return l;
}

/// Reads the speeds of [motion], and the load of the string at the start.
void read_motion(Config& whole, ChainPlan& p) {
  using namespace motion_keys;
  Config m = whole.table(StringMotion::table);
  const bool drills_itself = p.chain.top.axial == Top::Axial::autodriller;
  p.log = read_rig_log(whole);
  refuse_logged(m, rotary_speed, p.log.rotary_speed);
  refuse_logged(m, rate_of_penetration, p.log.block_speed);
  p.rotary_speed = is_given(p.log.rotary_speed) ? dynamics::value_at(p.log.rotary_speed, 0.0)
                                                : m.read(rotary_speed, 0.0);
  if (drills_itself) {
    refuse(m, rate_of_penetration, "a rate with axial = \"autodriller\"",
           "weight_on_bit alone: the autodriller determines the rate");
    p.surface_weight = m.read(weight_on_bit, std::nullopt);
  } else {
    p.rate = is_given(p.log.block_speed) ? dynamics::value_at(p.log.block_speed, 0.0)
                                         : m.read(rate_of_penetration, 0.0);
    refuse(m, weight_on_bit, "a weight without an autodriller",
           "string.top.axial = \"autodriller\", or rate_of_penetration");
  }
  const bool moves = p.start == ChainStart::steady && p.bit.law != BitLaw::fixed;
  const double rate = moves ? p.rate : 0.0, speed = moves ? p.rotary_speed : 0.0;
  StartLoad load = moves ? load_of_law(p.bit, rate, speed) : StartLoad{};
  if (m.has(weight_at_start)) load.weight = m.read(weight_at_start, 0.0);
  if (m.has(torque_at_start)) load.torque = m.read(torque_at_start, 0.0);
  p.motion = {rate, speed, p.bit.gravity_force - load.weight, load.torque};
}

/// Nodes that move must have mass.
void check_masses(Config& whole, const ChainPlan& p) {
  const auto& e = p.chain.elements;
  const auto massless = [&](const std::vector<double>& mass, double end) {
    return end <= 0.0 ||
           std::any_of(mass.begin() + 1, mass.end() - 1, [](double m) { return m <= 0.0; });
  };
  if ((p.chain.directions != string::Directions::torsion && massless(e.mass, p.bit.mass)) ||
      (p.chain.directions != string::Directions::axial && massless(e.inertia, p.bit.inertia)))
    whole.problem("string.sections", "nodes without mass or inertia",
                  "mass_per_length and inertia_per_length > 0, or one element and a bit with "
                  "string.mass and string.torsional_inertia");
}

/// Keys of a lumped string. For a chain their values follow from the sections.
void refuse_lumped(Config& c) {
  for (const char* name : {"axial_stiffness", "torsional_stiffness"})
    if (c.has(name) && c.quantity(name, name[0] == 'a' ? "N/m" : "N m/rad", 0.0) != 0.0) {
      c.problem(name, "a stiffness with model = \"chain\"",
                "none: it follows from [[string.sections]]");
    }
}

string::Chain make_chain(Config& c, const StringPlan& s, string::Directions directions,
                         double step) {
  string::Chain chain;
  const int count = element_count(c, s, step);
  chain.directions = directions;
  chain.elements = string::make_elements(s.sections, count);
  chain.contact = string::make_contact(s.sections, s.survey, s.friction, count);
  chain.threshold = s.threshold;
  chain.axial_damping = s.axial_damping;
  chain.torsional_damping = s.torsional_damping;
  chain.axial_loss_time = s.axial_loss_time;
  chain.torsional_loss_time = s.torsional_loss_time;
  if (chain.directions == string::Directions::axial && s.friction.back().resting > 0.0)
    c.table(StringDamping::table)
        .problem("static", "friction with directions = \"axial\"",
                 "none, or directions = \"both\"");
  return chain;
}

}  // namespace

ChainAbove read_chain_above(Config& whole, double step, double inertia,
                            std::vector<CaseWarning>& warnings) {
  Config c = whole.table(ChainSettings::table);
  refuse_lumped(c);
  const std::size_t mistakes = whole.problem_count();
  ChainAbove a;
  a.string = read_string_plan(whole, step, warnings);
  ChainSettings settings;
  read_fields(c, settings);
  a.start = settings.start;
  if (whole.problem_count() != mistakes)
    a.string.sections.assign(1, string::pipe(1.0, {0.1, 0.0, 0.1}, {}, 0.0, {}));
  a.chain = make_chain(c, a.string, settings.directions, step);
  std::vector<double> inertias = a.chain.elements.inertia;
  inertias.back() += inertia;
  const auto modes = string::lowest_modes(a.chain.elements.torsional, inertias, 1);
  Config top = c.table(TopSettings::table);
  a.chain.top =
      read_top(top, string::torsional_impedance(a.string.sections[0]), modes[0].frequency);
  return a;
}

double check_chain_step(Config& whole, double step, const string::Chain& chain, double mass,
                        double inertia) {
  const double longest = string::longest_step(chain, mass, inertia);
  if (step < longest || step == 0.0) return longest;
  string::Chain lossless = chain;
  lossless.axial_loss_time = lossless.torsional_loss_time = 0.0;
  Config c = whole.table(ChainSettings::table);
  if (step < string::longest_step(lossless, mass, inertia)) {
    Config friction = c.table(StringDamping::table);
    const char* key = chain.torsional_loss_time > 0.0 ? "torsional_loss_time" : "axial_loss_time";
    friction.problem(key, fmt::format("a time step of {:.6g} s", step),
                     fmt::format("a shorter loss time, or steps below {:.6g} s", longest));
    return longest;
  }
  c.problem(
      "element_length",
      fmt::format("elements of {:.6g} m with a time step of {:.6g} s", chain.elements.length, step),
      fmt::format("steps below {:.6g} s, or elements of at least {:.6g} m", longest,
                  1.01 * chain.elements.length * step / longest));
  return longest;
}

double read_hook_load(Config& whole, const dynamics::Schedule& logged, const string::Chain& chain,
                      double usual) {
  Config top = whole.table(ChainSettings::table).table(TopSettings::table);
  refuse_logged(top, top_keys::hook_load, logged);
  if (is_given(logged)) return dynamics::value_at(logged, 0.0);
  if (chain.top.axial == Top::Axial::hook_load) {
    HookLoad load{usual};
    read_fields(top, load);
    return load.hook_load;
  }
  refuse(top, top_keys::hook_load, "a hook load", "none, or axial = \"hook-load\"");
  return 0.0;
}

ChainOutput read_chain_output(Config& c, const string::Chain& chain, double step) {
  ChainOutputSettings s;
  read_fields(c, s);
  ChainOutput o;
  if (c.problem_count() > 0) return o;
  const double length = chain.elements.length * chain.count();
  for (const double depth : s.string_depths) {
    o.nodes.push_back(static_cast<int>(std::lround(depth / chain.elements.length)));
    if (depth >= 0.0 && depth <= length * (1.0 + 1e-9)) continue;
    c.problem("string_depths", fmt::format("{:.6g} m", depth),
              fmt::format("depths of the string, 0 to {:.6g} m", length));
    break;
  }
  if (s.string_profile_every > 0.0)
    o.profile_every =
        std::max(1L, std::lround(std::min(s.string_profile_every / std::max(step, 1e-300), 1e15)));
  return o;
}

void refuse_chain_output(Config& c) {
  refuse_fields<ChainOutputSettings>(c, {"a key of a chain", "none, or string.model = \"chain\""});
}

ChainPlan read_chain_plan(Config& whole, double step, std::vector<CaseWarning>& warnings) {
  Config c = whole.table(ChainSettings::table);
  ChainPlan p;
  ChainSettings settings;
  read_fields(c, settings);
  if (settings.model != StringModel::chain)
    c.problem("model", "sections of a string whose model is not \"chain\"", "model = \"chain\"");
  const std::size_t mistakes = whole.problem_count();
  ChainEnd own;
  read_fields(c, own);
  Gravity gravity;
  read_fields(c, gravity);
  ChainAbove above = read_chain_above(whole, step, own.torsional_inertia, warnings);
  p.string = std::move(above.string);
  p.chain = std::move(above.chain);
  p.start = above.start;
  const double end = string::total_length(p.string.sections);
  const double fall = string::tangent_at(p.string.survey, end).z();
  p.bit_weight = own.mass * gravity.gravity;
  p.bit = string::bit_below(p.chain, own.mass, own.torsional_inertia, p.bit_weight * fall);
  read_simple_bit(c, p.bit);
  read_motion(whole, p);
  p.hook_load = read_hook_load(whole, p.log.hook_load, p.chain,
                               string::steady_load(p.chain, p.motion).surface.hook_load);
  string::SteadyMotion off = p.motion;
  off.rate = 0.0;
  off.pull = p.bit.gravity_force;
  off.torque = p.chain.torsional_damping * p.chain.elements.inertia.back() * off.rotary_speed;
  p.chain.top.tare = string::steady_load(p.chain, off).surface.hook_load;
  check_masses(whole, p);
  const bool free = p.bit.law != BitLaw::fixed;
  if (whole.problem_count() == mistakes)
    p.longest_step =
        check_chain_step(whole, step, p.chain, free ? p.bit.mass : 0.0, free ? p.bit.inertia : 0.0);
  return p;
}

}  // namespace tdbd::simulation
