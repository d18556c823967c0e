#include <algorithm>
#include <numbers>

#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/led_bit.hpp"
#include "reference/literature/drag/wear/glowka_metres.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::reference {
namespace {

constexpr double absolute_zero = 273.15;  // K

/// Laws that give eps and zeta eps times the area of a virgin groove of the reference depth, for
/// the bit's first cutter. One law applies to all cutters.
GlowkaLaw law_of(const CompareCase& c) {
  const GlowkaSettings& s = c.options.glowka;
  const double area = virgin_area(glowka_face(c.ours.bit.cutters.front()), s.reference_depth);
  const double drag = c.rock->specific_energy * area;
  GlowkaLaw law;
  law.normal = {c.rock->normal_ratio * drag, s.reference_depth, s.power};
  law.drag = {drag, s.reference_depth, s.power};
  law.flat_stress = {s.flat_stress.value_or(0.0), s.reference_depth, 0.0};
  law.flat_friction = s.flat_friction;
  return law;
}

FlatHeat heat_of(const GlowkaSettings& s) {
  FlatHeat heat;
  heat.friction = s.flat_friction;
  heat.rock_conductivity = s.rock_conductivity;
  heat.rock_diffusivity = s.rock_diffusivity;
  heat.cutter_resistance = s.cutter_resistance;
  return heat;
}

/// A bit with its laws.
struct Asked {
  const CompareCase& c;
  GlowkaBit bit;
  GlowkaLaw law;
  FlatHeat heat;
  std::vector<double> sharp;
};

GlowkaLoads loads_at(const Asked& a, double advance) {
  GlowkaLoads loads;
  glowka_loads(a.bit, a.law, a.heat, a.sharp, {advance, a.c.ours.motion.rotary_speed}, loads);
  return loads;
}

void say_glowka_at_weight(const Asked& a, double weight, Findings& f) {
  if (weight <= 0.0) return set_missing(f, of_weight, no_weight);
  const double speed = a.c.ours.motion.rotary_speed;
  GlowkaLoads loads;
  const double advance = glowka_under_weight(a.bit, a.law, a.heat, a.sharp, weight, speed, loads);
  say(f, Quantity::rate_at_weight, advance * speed / (2.0 * std::numbers::pi));
  say(f, Quantity::torque_at_weight, loads.torque);
}

void say_loads_of_cutters(const Asked& a, const GlowkaLoads& loads, Findings& f) {
  std::vector<CutterNumbers> numbers;
  for (std::size_t i = 0; i < loads.cutters.size(); ++i) {
    const GlowkaCutterLoad& cutter = loads.cutters[i];
    numbers.push_back({cutter.area, cutter.volume, cutter.forces.normal, cutter.forces.drag});
    f.parts.push_back({simulation::cutter_name(a.bit.cutters[i]), a.bit.cutters[i].tip_radius,
                       PartQuantity::bending_moment, cutter.moment_B.head<2>().norm()});
  }
  set_cutter_quantities(a.c, numbers, f);
}

/// Sets flats and temperatures after the case's distance.
void say_wear(const Asked& a, Findings& f) {
  const GlowkaSettings& s = a.c.options.glowka;
  if (!s.flat_stress || !s.wear_coefficient)
    return set_missing(f, flats, "needs compare.glowka.flat_stress and wear_coefficient");
  WearLaw wear;
  wear.coefficient = *s.wear_coefficient;
  GlowkaWearOptions options;
  options.distance = s.distance;
  options.records = 1;
  const GlowkaWear worn =
      glowka_wear(a.bit, a.law, a.heat, wear, {a.c.advance, a.c.ours.motion.rotary_speed}, options);
  double largest = 0.0, hottest = 0.0;
  const GlowkaWearRecord& end = worn.records.back();
  for (std::size_t i = 0; i < end.loads.cutters.size(); ++i) {
    const GlowkaCutterLoad& cutter = end.loads.cutters[i];
    const double warm = cutter.temperature - absolute_zero;
    largest = std::max(largest, cutter.flat_area);
    hottest = std::max(hottest, warm);
    const std::string name = simulation::cutter_name(a.bit.cutters[i]);
    const double radius = a.bit.cutters[i].tip_radius;
    f.parts.push_back({name, radius, PartQuantity::wear_flat, cutter.flat_area});
    f.parts.push_back({name, radius, PartQuantity::temperature, warm});
  }
  say(f, Quantity::largest_wear_flat, largest);
  say(f, Quantity::hottest_flat, hottest);
  if (worn.worn_out)
    f.notes.push_back("a cutter lost half its face after " + std::to_string(end.distance) + " m");
}

}  // namespace

Findings run_glowka_model(const Question& q) {
  const CompareCase& c = q.asked;
  const Asked a{c, glowka_bit(c.ours.bit.cutters), law_of(c), heat_of(c.options.glowka),
                std::vector<double>(c.ours.bit.cutters.size())};
  const GlowkaLoads loads = loads_at(a, c.advance);
  Findings f;
  set_steady_load_quantities(f, loads.weight, loads.torque, c.advance);
  const Eigen::Vector2d lateral_B = loads.force_B.head<2>();
  set_lateral_quantities(lateral_B, lateral_B.norm(), f);
  double removed = 0.0;
  for (const GlowkaCutterLoad& cutter : loads.cutters) removed += cutter.volume;
  say(f, Quantity::removed_per_revolution, removed);
  say_loads_of_cutters(a, loads, f);
  say_glowka_at_weight(a, q.weight, f);
  say_wear(a, f);
  set_missing(f, Quantity::share_moved_backwards, "the bit turns about a fixed axis");
  set_missing(f, Quantity::resolution_at_gage, "one plane stands for the whole bottom");
  set_missing(f, of_cones, no_cones);
  add_whirl_note(c, f);
  return f;
}

}  // namespace tdbd::reference
