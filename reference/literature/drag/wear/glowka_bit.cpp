#include "reference/literature/drag/wear/glowka_bit.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// Directions at a cutter: into the rock, along the motion, radial.
struct GlowkaAxes {
  Vec3 normal, motion, radial;
};

GlowkaAxes glowka_axes(const bit::Cutter& c) {
  const Vec3 radial(std::cos(c.azimuth), std::sin(c.azimuth), 0.0);
  return {std::sin(c.profile_angle) * radial + std::cos(c.profile_angle) * Vec3::UnitZ(),
          Vec3(-radial.y(), radial.x(), 0.0), radial};
}

/// Sets the force of the rock on the cutter and its moment, from its sharp part and its flat.
void add_glowka_vectors(const bit::Cutter& c, GlowkaCutterLoad& load) {
  const GlowkaAxes x = glowka_axes(c);
  const double arm =
      load.area > 0.0 ? load.volume / (2.0 * std::numbers::pi * load.area) : c.tip_radius;
  const GlowkaForces& f = load.forces;
  const Vec3 sharp = -f.normal * x.normal - f.drag * x.motion;
  const Vec3 flat = -f.flat_normal * x.normal - f.flat_drag * x.motion;
  const Vec3 down = -c.tip_height * Vec3::UnitZ();
  load.force_B = sharp + flat;
  load.moment_B =
      (arm * x.radial + down).cross(sharp) + (c.tip_radius * x.radial + down).cross(flat);
}

void load_glowka_cutter(const bit::Cutter& c, const GlowkaLaw& law, const FlatHeat& heat,
                        double worn, double rotary_speed, GlowkaCutterLoad& load) {
  const GlowkaFace face = glowka_face(c);
  load.depth = effective_depth(face, load.area);
  load.flat_area = worn > 0.0 ? flat_area(face, worn) : 0.0;
  load.flat_stress = at_depth(law.flat_stress, load.depth);
  load.forces = glowka_forces(law, load.depth, load.flat_area);
  load.temperature = heat.fluid_temperature;
  if (load.forces.flat_normal > 0.0 && heat.friction > 0.0)
    load.temperature = flat_temperature(heat, load.forces.flat_normal, rotary_speed * c.tip_radius,
                                        load.flat_area, flat_length(face, worn));
  add_glowka_vectors(c, load);
}

void check_glowka_run(const GlowkaBit& bit, const std::vector<double>& worn, const GlowkaRun& run) {
  if (!(run.advance > 0.0))
    throw InputError("Glowka: found an advance of " + std::to_string(run.advance) +
                     " m per revolution, expected one above 0");
  if (!(run.rotary_speed > 0.0))
    throw InputError("Glowka: found a rotary speed of " + std::to_string(run.rotary_speed) +
                     " rad/s, expected one above 0");
  if (worn.size() != bit.cutters.size())
    throw InputError("Glowka: found the wear of " + std::to_string(worn.size()) +
                     " cutters, expected that of " + std::to_string(bit.cutters.size()));
  for (std::size_t i = 0; i < worn.size(); ++i)
    if (worn[i] > 0.0 && !(bit.cutters[i].back_rake > 0.0))
      throw InputError("Glowka: found cutter " + std::to_string(bit.cutters[i].id) +
                       " worn and without back rake, expected one above 0: its flat has no end");
}

}  // namespace

GlowkaBit glowka_bit(const std::vector<bit::Cutter>& cutters, double column) {
  return {cutters, worn_outlines(cutters, column)};
}

GlowkaFace glowka_face(const bit::Cutter& cutter) {
  return {cutter.diameter / 2.0, cutter.back_rake};
}

void glowka_loads(const GlowkaBit& bit, const GlowkaLaw& law, const FlatHeat& heat,
                  const std::vector<double>& worn, const GlowkaRun& run, GlowkaLoads& loads) {
  check_glowka_run(bit, worn, run);
  loads.along_normal.resize(worn.size());
  for (std::size_t i = 0; i < worn.size(); ++i)
    loads.along_normal[i] = worn[i] * std::cos(bit.cutters[i].back_rake);
  cut_worn(bit.outlines, loads.along_normal, run.advance, loads.cut);
  loads.cutters.resize(worn.size());
  loads.force_B.setZero();
  loads.moment_B.setZero();
  for (std::size_t i = 0; i < worn.size(); ++i) {
    GlowkaCutterLoad& load = loads.cutters[i];
    load.area = loads.cut.area[i];
    load.volume = loads.cut.volume[i];
    load_glowka_cutter(bit.cutters[i], law, heat, worn[i], run.rotary_speed, load);
    loads.force_B += load.force_B;
    loads.moment_B += load.moment_B;
  }
  loads.weight = -loads.force_B.z();
  loads.torque = -loads.moment_B.z();
}

double glowka_under_weight(const GlowkaBit& bit, const GlowkaLaw& law, const FlatHeat& heat,
                           const std::vector<double>& worn, double weight, double rotary_speed,
                           GlowkaLoads& loads) {
  constexpr double most = 0.1;  // m per revolution
  constexpr int halvings = 40;
  const auto carries = [&](double advance) {
    glowka_loads(bit, law, heat, worn, {advance, rotary_speed}, loads);
    return loads.weight >= weight;
  };
  if (!(weight > 0.0) || !carries(most))
    throw InputError("Glowka: found a weight of " + std::to_string(weight) +
                     " N, expected one that the bit carries at an advance above 0 and up to 0.1 m");
  double low = 0.0, high = most;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (carries(middle) ? high : low) = middle;
  }
  carries(high);
  return high;
}

}  // namespace tdbd::reference
