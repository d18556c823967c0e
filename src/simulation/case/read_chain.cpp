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

/// The fastest wave of the sections, m/s.
double fastest_wave(const std::vector<string::Section>& sections) {
  double fastest = 0.0;
  for (const string::Section& s : sections) {
    if (s.mass > 0.0) fastest = std::max(fastest, string::axial_wave_speed(s));
    if (s.inertia > 0.0) fastest = std::max(fastest, string::torsional_wave_speed(s));
  }
  return fastest;
}

/// Elements of about the wanted length, at least two where the string has mass.
int element_count(Config& c, const StringPlan& p, double step) {
  constexpr double usual = 10.0, courant = 0.9, most = 1e5;
  const double length = string::total_length(p.sections), wave = fastest_wave(p.sections);
  const double wanted =
      c.read(chain_keys::element_length, std::min(std::max(usual, wave * step / courant), length));
  const double count = std::round(length / wanted);
  if (count <= most) return std::max(1, static_cast<int>(count));
  c.problem(chain_keys::element_length,
            fmt::format("{:.6g} m, which makes {:.0f} elements", wanted, count),
            fmt::format("at most {:.0f} elements", most));
  return 1;
}

/// Whether the table has the key, which this kind of top refuses.
void refuse(Config& c, const QuantityKey& key, const std::string& found,
            const std::string& expected) {
  if (!c.has(key)) return;
  c.read(key);
  c.problem(key, found, expected);
}

/// Gains of a top drive from what the case gives; `frequency`: the usual one, Hz.
void read_drive(Config& c, double impedance, double frequency, Top& top) {
  using namespace top_keys;
  const TopDrive drive = c.read(torsion);
  const bool tuned = drive == TopDrive::soft_torque || drive == TopDrive::z_torque;
  if (drive != TopDrive::soft_torque)
    refuse(c, tuned_frequency, "a frequency without torsion = \"soft-torque\"",
           "none, or that top drive");
  if (drive != TopDrive::z_torque)
    refuse(c, compensation, "a compensation without torsion = \"z-torque\"",
           "none, or that top drive");
  if (!tuned)
    refuse(c, impedance_factor, "a factor without soft-torque or z-torque",
           "none, or one of these top drives");
  if (drive == TopDrive::speed) {
    for (const QuantityKey& key : {inertia, proportional, integral, torque_limit})
      refuse(c, key, "a key of a top drive with torsion = \"speed\"",
             "none, or torsion = \"pi\", \"soft-torque\" or \"z-torque\"");
    return;
  }
  top.torsion = Top::Torsion::pi;
  top.inertia = c.read(inertia);
  if (c.has(torque_limit)) top.torque_limit = c.read(torque_limit);
  if (tuned && c.has(proportional)) {
    c.read(proportional);
    c.problem(proportional, "a gain with a tuned top drive",
              "impedance_factor, or torsion = \"pi\"");
  }
  if (drive == TopDrive::soft_torque) {
    refuse(c, integral, "a gain with soft-torque", "tuned_frequency, or torsion = \"pi\"");
    string::tune_soft_torque(top, impedance, c.read(impedance_factor),
                             c.read(tuned_frequency, frequency));
    return;
  }
  top.integral = c.read(integral);
  if (drive == TopDrive::z_torque)
    string::tune_z_torque(top, impedance, c.read(impedance_factor), c.read(compensation));
  else
    top.proportional = c.read(proportional);
}

void read_autodriller(Config& c, Top& top) {
  using namespace top_keys;
  if (top.axial != Top::Axial::autodriller) {
    for (const QuantityKey& key : {gain, integral_gain, filter})
      refuse(c, key, "a key of an autodriller", "none, or axial = \"autodriller\"");
    return;
  }
  top.gain = c.read(gain);
  top.integral_gain = c.read(integral_gain);
  top.filter = c.read(filter);
  const std::vector<double> limits =
      c.read(rate_limits, std::optional(std::vector<double>{0.0, 60.0 / 3600.0}));
  if (limits.size() != 2 || !(limits[0] < limits[1])) {
    c.problem(rate_limits, "no two ascending rates", "the slowest and the fastest rate");
    return;
  }
  top.least_rate = limits[0];
  top.largest_rate = limits[1];
}

/// Keys that the law of the bit has and those that it does not.
void read_law(Config& c, string::SimpleBit& b) {
  using namespace simple_bit_keys;
  b.law = c.read(law);
  b.weight = c.read(weight);
  b.torque = c.read(torque);
  b.axial_damping += c.read(axial_damping, 0.0);
  b.torsional_damping += c.read(torsional_damping, 0.0);
  if (b.law == BitLaw::two_level) {
    b.resting_torque = c.read(resting);
    b.sliding_torque = c.read(sliding);
    if (b.sliding_torque > b.resting_torque)
      c.problem(sliding, fmt::format("{:.6g} N m", b.sliding_torque),
                fmt::format("at most the torque at rest, {:.6g} N m", b.resting_torque));
  } else {
    for (const QuantityKey& key : {resting, sliding})
      refuse(c, key, "a key of another law", "none, or law = \"two-level\"");
  }
  if (b.law == BitLaw::regenerative) {
    b.force_per_depth = c.read(force_per_depth);
    b.torque_per_depth = c.read(torque_per_depth);
    b.contact_force = c.read(contact_force, 0.0);
    b.contact_lever = c.read(contact_lever, 0.0);
    b.pitch = c.read(pitch);
  } else {
    for (const QuantityKey& key :
         {force_per_depth, torque_per_depth, contact_force, contact_lever, pitch})
      refuse(c, key, "a key of another law", "none, or law = \"regenerative\"");
  }
}

/// What the bit takes at the start, N and N m.
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

/// Speeds of [motion], and the load that the string carries at the start.
void read_motion(Config& whole, ChainPlan& p) {
  using namespace motion_keys;
  Config m = whole.table(table);
  const bool drills_itself = p.chain.top.axial == Top::Axial::autodriller;
  p.log = read_rig_log(whole);
  refuse_logged(m, rotary_speed, p.log.rotary_speed);
  refuse_logged(m, rate_of_penetration, p.log.block_speed);
  p.rotary_speed = is_given(p.log.rotary_speed) ? dynamics::value_at(p.log.rotary_speed, 0.0)
                                                : m.read(rotary_speed, 0.0);
  if (drills_itself) {
    refuse(m, rate_of_penetration, "a rate with axial = \"autodriller\"",
           "weight_on_bit alone: the autodriller finds the rate");
    p.surface_weight = m.read(weight_on_bit);
  } else {
    p.rate = is_given(p.log.block_speed) ? dynamics::value_at(p.log.block_speed, 0.0)
                                         : m.read(rate_of_penetration, 0.0);
    refuse(m, weight_on_bit, "a weight without an autodriller",
           "string.top.axial = \"autodriller\", or rate_of_penetration");
  }
  const bool moves = p.start == ChainStart::steady && p.bit.law != BitLaw::fixed;
  const double rate = moves ? p.rate : 0.0, speed = moves ? p.rotary_speed : 0.0;
  StartLoad load = moves ? load_of_law(p.bit, rate, speed) : StartLoad{};
  if (m.has(weight_at_start)) load.weight = m.read(weight_at_start);
  if (m.has(torque_at_start)) load.torque = m.read(torque_at_start);
  p.motion = {rate, speed, p.bit.gravity_force - load.weight, load.torque};
}

/// Nodes that move have mass.
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

/// Keys of a lumped string, whose values follow from the sections.
void refuse_lumped(Config& c) {
  for (const char* name : {"axial_stiffness", "torsional_stiffness"})
    if (c.has(name) && c.quantity(name, name[0] == 'a' ? "N/m" : "N m/rad", 0.0) != 0.0) {
      c.problem(name, "a stiffness with model = \"chain\"",
                "none: it follows from [[string.sections]]");
    }
}

string::Chain make_chain(Config& c, const StringPlan& s, double step) {
  string::Chain chain;
  const int count = element_count(c, s, step);
  chain.directions = c.read(chain_keys::directions);
  chain.elements = string::make_elements(s.sections, count);
  chain.contact = string::make_contact(s.sections, s.survey, s.friction, count);
  chain.threshold = s.threshold;
  chain.axial_damping = s.axial_damping;
  chain.torsional_damping = s.torsional_damping;
  chain.axial_loss_time = s.axial_loss_time;
  chain.torsional_loss_time = s.torsional_loss_time;
  if (chain.directions == string::Directions::axial && s.friction.back().resting > 0.0)
    c.table(string_friction_keys::table)
        .problem(string_friction_keys::resting, "friction with directions = \"axial\"",
                 "none, or directions = \"both\"");
  return chain;
}

}  // namespace

ChainAbove read_chain_above(Config& whole, double step, double inertia,
                            std::vector<CaseWarning>& warnings) {
  Config c = whole.table(chain_keys::table);
  refuse_lumped(c);
  const std::size_t mistakes = whole.problem_count();
  ChainAbove a;
  a.string = read_string_plan(whole, step, warnings);
  a.start = c.read(chain_keys::start);
  if (whole.problem_count() != mistakes)
    a.string.sections.assign(1, string::pipe(1.0, {0.1, 0.0, 0.1}, {}, 0.0, {}));
  a.chain = make_chain(c, a.string, step);
  std::vector<double> inertias = a.chain.elements.inertia;
  inertias.back() += inertia;
  const auto modes = string::lowest_modes(a.chain.elements.torsional, inertias, 1);
  Config top = c.table(top_keys::table);
  read_drive(top, string::torsional_impedance(a.string.sections[0]), modes[0].frequency,
             a.chain.top);
  a.chain.top.axial = top.read(top_keys::axial);
  read_autodriller(top, a.chain.top);
  return a;
}

double check_chain_step(Config& whole, double step, const string::Chain& chain, double mass,
                        double inertia) {
  const double longest = string::longest_step(chain, mass, inertia);
  if (step < longest || step == 0.0) return longest;
  string::Chain lossless = chain;
  lossless.axial_loss_time = lossless.torsional_loss_time = 0.0;
  Config c = whole.table(chain_keys::table);
  if (step < string::longest_step(lossless, mass, inertia)) {
    Config friction = c.table(string_friction_keys::table);
    const auto key = chain.torsional_loss_time > 0.0
                         ? std::string_view(string_friction_keys::torsional_loss_time)
                         : std::string_view(string_friction_keys::axial_loss_time);
    friction.problem(key, fmt::format("a time step of {:.6g} s", step),
                     fmt::format("a shorter loss time, or steps below {:.6g} s", longest));
    return longest;
  }
  c.problem(
      chain_keys::element_length,
      fmt::format("elements of {:.6g} m with a time step of {:.6g} s", chain.elements.length, step),
      fmt::format("steps below {:.6g} s, or elements of at least {:.6g} m", longest,
                  1.01 * chain.elements.length * step / longest));
  return longest;
}

double read_hook_load(Config& whole, const dynamics::Schedule& logged, const string::Chain& chain,
                      double usual) {
  Config top = whole.table(chain_keys::table).table(top_keys::table);
  refuse_logged(top, top_keys::hook_load, logged);
  if (is_given(logged)) return dynamics::value_at(logged, 0.0);
  if (chain.top.axial == Top::Axial::hook_load) return top.read(top_keys::hook_load, usual);
  refuse(top, top_keys::hook_load, "a hook load", "none, or axial = \"hook-load\"");
  return 0.0;
}

ChainOutput read_chain_output(Config& c, const string::Chain& chain, double step) {
  using namespace chain_output_keys;
  const std::vector<double> depths = c.read(string_depths, std::optional(std::vector<double>{}));
  const double every = c.has(string_profile_every) ? c.read(string_profile_every) : 0.0;
  ChainOutput o;
  if (c.problem_count() > 0) return o;
  const double length = chain.elements.length * chain.count();
  for (const double depth : depths) {
    o.nodes.push_back(static_cast<int>(std::lround(depth / chain.elements.length)));
    if (depth >= 0.0 && depth <= length * (1.0 + 1e-9)) continue;
    c.problem(string_depths, fmt::format("{:.6g} m", depth),
              fmt::format("depths of the string, 0 to {:.6g} m", length));
    break;
  }
  if (every > 0.0)
    o.profile_every = std::max(1L, std::lround(std::min(every / std::max(step, 1e-300), 1e15)));
  return o;
}

void refuse_chain_output(Config& c) {
  using namespace chain_output_keys;
  constexpr const char* found = "a key of a chain";
  constexpr const char* expected = "none, or string.model = \"chain\"";
  if (c.has(string_depths)) {
    c.read(string_depths);
    c.problem(string_depths, found, expected);
  }
  refuse(c, string_profile_every, found, expected);
}

ChainPlan read_chain_plan(Config& whole, double step, std::vector<CaseWarning>& warnings) {
  Config c = whole.table(chain_keys::table);
  ChainPlan p;
  if (c.read(chain_keys::model) != StringModel::chain)
    c.problem(chain_keys::model, "sections of a string whose model is not \"chain\"",
              "model = \"chain\"");
  const std::size_t mistakes = whole.problem_count();
  const double mass = c.read(chain_keys::mass), inertia = c.read(chain_keys::torsional_inertia);
  const double gravity = c.read(chain_keys::gravity);
  ChainAbove above = read_chain_above(whole, step, inertia, warnings);
  p.string = std::move(above.string);
  p.chain = std::move(above.chain);
  p.start = above.start;
  const double end = string::total_length(p.string.sections);
  const double fall = string::tangent_at(p.string.survey, end).z();
  p.bit_weight = mass * gravity;
  p.bit = string::bit_below(p.chain, mass, inertia, p.bit_weight * fall);
  Config bit = c.table(simple_bit_keys::table);
  read_law(bit, p.bit);
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
