#include "reference/compare/compare_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "forces/law.hpp"
#include "reference/compare/compare_keys.hpp"

namespace tdbd::reference {
namespace {

constexpr double full_circle = 2.0 * std::numbers::pi;

namespace keys = compare_keys;

std::optional<double> read_if_given(Config& c, const QuantityKey& key) {
  if (!c.has(key)) return std::nullopt;
  return c.read(key, 0.0);
}

GlowkaSettings read_glowka(Config c) {
  GlowkaSettings s;
  s.power = c.read(keys::power);
  s.reference_depth = c.read(keys::reference_depth);
  s.flat_stress = read_if_given(c, keys::flat_stress);
  s.wear_coefficient = read_if_given(c, keys::wear_coefficient);
  s.distance = c.read(keys::distance);
  s.flat_friction = c.read(keys::flat_friction);
  s.rock_conductivity = c.read(keys::rock_conductivity);
  s.rock_diffusivity = c.read(keys::rock_diffusivity);
  s.cutter_resistance = c.read(keys::cutter_resistance);
  return s;
}

RollerSettings read_roller(Config c) {
  RollerSettings s;
  s.specific_energy = read_if_given(c, keys::specific_energy);
  s.normal_ratio = c.read(keys::normal_ratio);
  s.half_angle = c.read(keys::half_angle);
  if (c.has(keys::tooth_table)) s.tooth_table = c.read(keys::tooth_table);
  s.penetration = read_if_given(c, keys::penetration);
  s.cone_ratio = read_if_given(c, keys::cone_ratio);
  s.tooth_half_angle = c.read(keys::tooth_half_angle);
  return s;
}

WintersSettings read_winters(Config c) {
  WintersSettings s;
  s.weights = c.read(keys::weights, std::vector<double>());
  s.rates = c.read(keys::rates, std::vector<double>());
  s.strength = c.read(keys::strength);
  if (s.weights.size() != s.rates.size())
    c.problem(keys::rates, fmt::format("{} rates", s.rates.size()),
              fmt::format("{}, one for each weight", s.weights.size()));
  return s;
}

CompareOptions read_options(Config c) {
  CompareOptions o;
  o.models = c.read(keys::models, std::vector<std::string>{"all"});
  o.counted_revolutions = c.read(keys::counted_revolutions);
  if (c.has(keys::weight_on_bit)) o.weight_on_bit = c.read(keys::weight_on_bit, 0.0);
  o.circle = c.read(keys::circle);
  o.circle_samples = static_cast<int>(c.read(keys::circle_samples));
  o.outline = c.read(keys::outline);
  Config planes = c.table("planes");
  o.planes = static_cast<int>(planes.read(keys::planes));
  o.plane_nodes = static_cast<int>(planes.read(keys::nodes));
  Config spokes = c.table("spokes");
  o.spokes = static_cast<int>(spokes.read(keys::spokes));
  o.spoke_nodes = static_cast<int>(spokes.read(keys::spoke_nodes));
  o.spoke_spacing = spokes.read(keys::spacing);
  o.glowka = read_glowka(c.table("glowka"));
  o.roller = read_roller(c.table("roller"));
  o.winters = read_winters(c.table("winters"));
  return o;
}

/// The coefficients that drag-bit models share, if the law of the faces has no others.
std::optional<DragRock> rock_of(const simulation::ForcePlan& forces) {
  const auto* law =
      std::get_if<forces::Detournay>(&simulation::law_of(forces, bit::PartKind::face));
  if (law == nullptr) return std::nullopt;
  return DragRock{law->eps, law->zeta, law->sigma, law->mu};
}

/// Chamfers may have a law of their own; without chamfers, any law for them is accepted.
std::optional<EdgeCoefficients> edges_of(const simulation::ForcePlan& forces) {
  using forces::HansonHansen;
  const auto law_of = [&](bit::PartKind kind) {
    return std::get_if<HansonHansen>(&simulation::law_of(forces, kind));
  };
  const HansonHansen* face = law_of(bit::PartKind::face);
  if (face == nullptr || forces.rock.strengths.size() != 1) return std::nullopt;
  const forces::Strength& s = forces.rock.strengths.front();
  EdgeCoefficients c;
  c.strength = s.unconfined + face->pressure_share * (s.confined - s.unconfined);
  c.A1 = face->A1, c.A2 = face->A2, c.A3 = face->A3, c.A4 = face->A4, c.te = face->te;
  const HansonHansen* chamfer = law_of(bit::PartKind::chamfer);
  c.A5 = chamfer ? chamfer->A5 : 0.0;
  c.A6 = chamfer ? chamfer->A6 : 0.0;
  c.A7 = face->A7, c.A8 = face->A8;
  return c;
}

/// Empty without a tangential force, because the ratio to it would be undefined.
std::optional<DragRock> tips_of(const simulation::ForcePlan& forces) {
  const auto* law =
      std::get_if<forces::DepthOfCut>(&simulation::law_of(forces, bit::PartKind::face));
  if (law == nullptr || !(law->kt > 0.0)) return std::nullopt;
  return DragRock{law->kt, law->kn / law->kt, 0.0, 0.0};
}

/// File positions of keys whose mistakes are only found when everything has been read.
struct Places {
  std::string motion, forces, counted, circle, weight;
};

Places places_of(const Config& c) {
  return {c.place("motion"), c.place("forces"), c.place("compare.counted_revolutions"),
          c.place("compare.circle"), c.place("compare.weight_on_bit")};
}

/// The rate of a bit on a string is a result, so only its rotary speed is required.
void check_string_motion(const Places& at, const simulation::Motion& m) {
  if (!(m.rotary_speed > 0.0))
    throw InputError(at.motion + ": found a bit that does not turn, expected rotary_speed above 0");
}

void check_motion(const Places& at, const simulation::Motion& m) {
  using simulation::MotionKind;
  if (m.kind == MotionKind::legs || m.kind == MotionKind::table)
    throw InputError(at.motion +
                     ": found a path, expected steady, whirl or drilling: the models know no "
                     "others");
  if (m.kind == MotionKind::drilling) return check_string_motion(at, m);
  if (!(m.rotary_speed > 0.0 && m.rate_of_penetration > 0.0))
    throw InputError(at.motion +
                     ": found a bit that does not turn or does not advance, expected "
                     "rotary_speed and rate_of_penetration above 0");
}

void check(const Places& at, const CompareCase& c) {
  check_motion(at, c.ours.motion);
  if (c.ours.forces.forces == simulation::Forces::off)
    throw InputError(at.forces +
                     ": found no such table, expected force laws: weight and torque "
                     "are what models differ in");
  if (!c.ours.forces.part_laws.empty())
    throw InputError(at.forces +
                     ": found laws by area ([forces.areas]), expected one law for each kind of "
                     "part; the other models have no areas");
  if (c.ours.time.steps - c.ours.time.first < counted_steps(c))
    throw InputError(fmt::format("{}: found {:g}, expected no more revolutions than the run has",
                                 at.counted, c.options.counted_revolutions));
  if (is_free(c) && c.options.weight_on_bit)
    throw InputError(at.weight + ": found a weight, expected none: motion gives that of a string");
  if (c.options.circle > 0.999 * c.ours.bit.gage_radius)
    throw InputError(
        fmt::format("{}: found {:g} m, expected less than the bit's gage radius, {:g} m", at.circle,
                    c.options.circle, c.ours.bit.gage_radius));
}

}  // namespace

CompareCase read_compare_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config config = Config::read_file(path, overrides);
  CompareCase c;
  c.options = read_options(config.table(compare_keys::table));
  const Places places = places_of(config);
  c.ours = simulation::read_case(config, path);
  const simulation::Motion& m = c.ours.motion;
  c.advance = m.rotary_speed > 0.0 ? m.rate_of_penetration * full_circle / m.rotary_speed : 0.0;
  c.rock = rock_of(c.ours.forces);
  c.edges = edges_of(c.ours.forces);
  c.tips = tips_of(c.ours.forces);
  c.resolved = c.ours.resolved;
  check(places, c);
  if (is_free(c) && m.driven.top.axial == dynamics::AxialMode::load)
    c.options.weight_on_bit = dynamics::value_at(m.driven.top.load, 0.0);
  return c;
}

bool is_free(const CompareCase& c) {
  return c.ours.motion.kind == simulation::MotionKind::drilling;
}

long counted_steps(const CompareCase& c) {
  const double turn = c.ours.motion.rotary_speed * c.ours.time.step;
  return std::max(1L, std::lround(c.options.counted_revolutions * full_circle / turn));
}

}  // namespace tdbd::reference
