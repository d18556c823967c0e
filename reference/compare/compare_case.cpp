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

CompareOptions read_options(Config c) {
  namespace keys = compare_keys;
  CompareOptions o;
  o.models = c.read(keys::models, std::vector<std::string>{"all"});
  o.counted_revolutions = c.read(keys::counted_revolutions);
  if (c.has(keys::weight_on_bit)) o.weight_on_bit = c.read(keys::weight_on_bit, 0.0);
  o.circle = c.read(keys::circle);
  o.circle_samples = static_cast<int>(c.read(keys::circle_samples));
  Config planes = c.table("planes");
  o.planes = static_cast<int>(planes.read(keys::planes));
  o.plane_nodes = static_cast<int>(planes.read(keys::nodes));
  Config spokes = c.table("spokes");
  o.spokes = static_cast<int>(spokes.read(keys::spokes));
  o.spoke_nodes = static_cast<int>(spokes.read(keys::spoke_nodes));
  o.spoke_spacing = spokes.read(keys::spacing, 0.0);
  return o;
}

/// The numbers that drag-bit models share, if the law of the faces has no others.
std::optional<DragRock> rock_of(const simulation::ForcePlan& forces) {
  const auto* law =
      std::get_if<forces::Detournay>(&simulation::law_of(forces, bit::PartKind::face));
  if (law == nullptr) return std::nullopt;
  return DragRock{law->eps, law->zeta, law->sigma, law->mu};
}

void check(const std::string& path, const CompareCase& c) {
  const simulation::Motion& m = c.ours.motion;
  const bool prescribed =
      m.kind == simulation::MotionKind::steady || m.kind == simulation::MotionKind::whirl;
  if (!prescribed)
    throw InputError(
        fmt::format("{}: motion.kind: found another kind, expected steady or whirl: the models are "
                    "compared on one given motion",
                    c.ours.places.motion.empty() ? path : c.ours.places.motion));
  if (!(m.rotary_speed > 0.0 && m.rate_of_penetration > 0.0))
    throw InputError(path +
                     ": motion: found a bit that does not turn or does not advance, expected "
                     "a rotary_speed and a rate_of_penetration above 0");
  if (c.ours.forces.forces == simulation::Forces::off)
    throw InputError(path +
                     ": forces: found no table [forces], expected force laws: weight and "
                     "torque are what the models differ in");
  if (c.ours.time.steps < counted_steps(c))
    throw InputError(
        fmt::format("{}: compare.counted_revolutions: found {:g}, expected no more revolutions "
                    "than the run has",
                    path, c.options.counted_revolutions));
  if (c.options.circle > 0.999 * c.ours.bit.gage_radius)
    throw InputError(
        fmt::format("{}: compare.circle: found {:g} m, expected less than the bit's "
                    "gage radius, {:g} m",
                    path, c.options.circle, c.ours.bit.gage_radius));
}

}  // namespace

CompareCase read_compare_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config config = Config::read_file(path, overrides);
  CompareCase c;
  c.options = read_options(config.table(compare_keys::table));
  c.ours = simulation::read_case(config, path);
  if (c.options.spoke_spacing == 0.0) c.options.spoke_spacing = c.ours.rock.edge_length;
  const simulation::Motion& m = c.ours.motion;
  c.advance = m.rotary_speed > 0.0 ? m.rate_of_penetration * full_circle / m.rotary_speed : 0.0;
  c.rock = rock_of(c.ours.forces);
  c.resolved = c.ours.resolved;
  check(path, c);
  return c;
}

long counted_steps(const CompareCase& c) {
  const double turn = c.ours.motion.rotary_speed * c.ours.time.step;
  return std::max(1L, std::lround(c.options.counted_revolutions * full_circle / turn));
}

}  // namespace tdbd::reference
