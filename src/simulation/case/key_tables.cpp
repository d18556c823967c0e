#include "simulation/case/key_tables.hpp"

#include <fmt/format.h>

#include "bit/areas/area_keys.hpp"
#include "bit/files/bit_tables.hpp"
#include "simulation/case/chain_keys.hpp"
#include "simulation/case/drilling_keys.hpp"
#include "simulation/case/force_keys.hpp"
#include "simulation/case/motion_keys.hpp"
#include "simulation/case/rig_log_keys.hpp"
#include "simulation/case/rock_keys.hpp"
#include "simulation/case/rotate_keys.hpp"
#include "simulation/case/run_keys.hpp"
#include "simulation/case/spalling_keys.hpp"
#include "simulation/case/title_key.hpp"
#include "simulation/case/wear_keys.hpp"

namespace tdbd::simulation {
namespace {

std::vector<KeyTable> rock_tables() {
  using namespace rock_keys;
  using namespace formation_keys;
  return {
      key_table("run", table,
                rows(shape, edge_length, wall, radius, amplitude, correlation_length, seed, profile,
                     file, unit, intersection_check, trim, material, pressure, pore_pressure,
                     overburden, confinement, dip, dip_azimuth)),
      key_table("run", material_table, rows(name, unconfined_strength, friction_angle, porosity)),
      key_table("run", layers, rows(top, material))};
}

KeyTable motion_table() {
  using namespace motion_keys;
  return key_table(
      "run", table,
      rows(kind, start, rotary_speed, rate_of_penetration, file, weight_on_bit, expected_rate,
           rate_memory, weight_at_start, torque_at_start, cone_speeds, cone_drive, cone_memory));
}

KeyTable whirl_table() {
  using namespace whirl_keys;
  return key_table("run", table, rows(radius, frequency, sense, ramp));
}

KeyTable tilt_table() {
  using namespace tilt_keys;
  return key_table("run", table, rows(angle, azimuth, frequency, sense, ramp));
}

KeyTable leg_table() {
  using namespace leg_keys;
  return key_table("run", table, rows(duration, velocity, rotary_speed));
}

/// The values' unit is that of the quantity that changes over time.
KeyTable schedule_table() {
  using namespace schedule_keys;
  return key_table("run", table,
                   rows(times, values({.name = "KEY", .unit = "KEY's unit"}), between));
}

KeyTable time_table() {
  using namespace time_keys;
  return key_table("run", table, rows(step, duration, revolutions, first_step));
}

KeyTable update_table() {
  using namespace update_keys;
  return key_table(
      "run", table,
      rows(directions, inside_cutters, gage_teeth, leaning, exit_search, exit_from, most_passes));
}

KeyTable maintenance_table() {
  using namespace maintenance_keys;
  return key_table("run", table,
                   rows(every, rest, longest_wait, renumber_every, shortest_edge, longest_edge,
                        worst_quality, flip_quality, smoothing, smooth_quality));
}

KeyTable measure_table() {
  using namespace measure_keys;
  return key_table(
      "run", table,
      rows(section, section_lead, section_at_face, section_every, contact, contact_gap));
}

KeyTable output_table() {
  using namespace output_keys;
  return key_table("run", table,
                   rows(history_every, frames_every, checkpoint_every, means_from, convergence,
                        energy_order, energy_order_window, chain_output_keys::string_depths,
                        chain_output_keys::string_profile_every));
}

/// The kinds of part on which a coefficient acts, where these are not all that its law knows.
std::string where_it_acts(const forces::Law& law, const forces::LawField& field) {
  std::string kinds;
  bool on_all = true;
  for (const bit::PartKind kind : bit::part_kinds) {
    if (forces::acts_on(field, kind))
      kinds += fmt::format("{}{}", kinds.empty() ? "; acts on: " : ", ", bit::kind_words(kind));
    else if (forces::knows(law, kind))
      on_all = false;
  }
  return on_all ? "" : kinds;
}

KeyTable area_table() {
  namespace area = bit::area_keys;
  return key_table("run", force_keys::areas_table,
                   rows(area::kind, area::zone, area::blade, area::cone, area::row, area::names,
                        area::part, force_keys::area_law, force_keys::coefficients));
}

/// [forces], and the coefficients of every law that has any.
std::vector<KeyTable> force_tables() {
  using namespace force_keys;
  std::vector<KeyTable> tables{
      key_table("run", table, rows(law, coefficients, cut, chamfer_contact, flat_contact)),
      key_table("run", kind_table, rows(law, coefficients)), area_table()};
  for (const std::string_view name : forces::law_names()) {
    forces::Law each = forces::law_named(name);
    std::vector<KeyRow> fields;
    for (const forces::LawField& field : forces::law_fields(each)) {
      fields.push_back(row(key_of(field)));
      fields.back().meaning += where_it_acts(each, field);
    }
    const std::string meaning = fmt::format("coefficients of the law \"{}\"", name);
    if (!fields.empty())
      tables.push_back(key_table("run", {.name = "forces", .meaning = meaning}, std::move(fields)));
  }
  return tables;
}

std::vector<KeyTable> wear_tables() {
  namespace area = bit::area_keys;
  using namespace wear_keys;
  return {
      key_table("run", table,
                rows(law, coefficient, hardness, threshold, growth, temperatures, rates,
                     acceleration, from, every_steps, every, largest_growth, friction,
                     rock_conductivity, rock_diffusivity, cutter_resistance, fluid_temperature)),
      // Not cone, row: no part of a cone wears.
      key_table("run", areas_table,
                rows(area::kind, area::zone, area::blade, area::names, area::part, law, coefficient,
                     hardness, threshold, growth, temperatures, rates))};
}

std::vector<KeyTable> spalling_tables() {
  namespace area = bit::area_keys;
  using namespace spalling_keys;
  return {key_table("run", table, rows(angle, depth_share, ahead_share, up_to_pressure, material)),
          // Not cone, row: rock breaks out beside faces of cutters alone.
          key_table("run", areas_table,
                    rows(area::kind, area::zone, area::blade, area::names, area::part, angle,
                         depth_share, ahead_share))};
}

KeyTable string_table() {
  using namespace string_keys;
  return key_table(
      "run", table,
      rows(mass, bending_inertia, torsional_inertia, lateral_stiffness, axial_stiffness,
           bending_stiffness, torsional_stiffness, lateral_damping, axial_damping, bending_damping,
           torsional_damping, dampers_to, bearing_damping, attachment_height, gravity,
           chain_keys::model, chain_keys::directions, chain_keys::element_length, chain_keys::start,
           chain_keys::hole_diameter));
}

KeyTable wall_table() {
  using namespace wall_keys;
  return key_table("run", table,
                   rows(model, stiffness, clearance, ring_radius, ring_height, restitution,
                        friction, slip_speed));
}

KeyTable rock_mount_table() {
  using namespace rock_mount_keys;
  return key_table("run", table, rows(mass, stiffness, damping));
}

/// Of a string on a chain, with a bit that drills or without a shape.
std::vector<KeyTable> chain_tables_of(const std::string& command) {
  namespace section = section_keys;
  namespace friction = string_friction_keys;
  namespace top = top_keys;
  namespace log = rig_log_keys;
  return {
      key_table(command, section::table,
                rows(section::length, section::outer_diameter, section::inner_diameter,
                     section::contact_diameter, section::material, section::young, section::shear,
                     section::density, section::linear_mass, section::axial_rigidity,
                     section::torsional_rigidity, section::mass_per_length,
                     section::inertia_per_length, section::weight_per_length)),
      key_table(command, survey_keys::table,
                rows(survey_keys::file, survey_keys::measured_depth, survey_keys::inclination,
                     survey_keys::azimuth)),
      key_table(command, friction::table,
                rows(friction::resting, friction::sliding, friction::threshold,
                     friction::mud_density, friction::axial_damping, friction::torsional_damping,
                     friction::axial_loss_time, friction::torsional_loss_time)),
      key_table(command, friction::above,
                rows(friction::depth, friction::resting, friction::sliding)),
      key_table(
          command, top::table,
          rows(top::torsion, top::inertia, top::proportional, top::integral, top::tuned_frequency,
               top::impedance_factor, top::compensation, top::torque_limit, top::axial,
               top::hook_load, top::gain, top::integral_gain, top::filter, top::rate_limits)),
      key_table(command, log::table,
                rows(log::file, log::time, log::rotary_speed, log::block_speed, log::hook_load,
                     log::start))};
}

std::vector<KeyTable> string_tables() {
  namespace bit = simple_bit_keys;
  namespace out = chain_output_keys;
  using namespace chain_keys;
  return {
      key_table("string", title_keys::table, rows(title_keys::title)),
      key_table("string", table,
                rows(model, directions, element_length, chain_keys::start, mass, torsional_inertia,
                     gravity, hole_diameter)),
      key_table("string", bit::table,
                rows(bit::law, bit::weight, bit::torque, bit::resting, bit::sliding,
                     bit::force_per_depth, bit::torque_per_depth, bit::contact_force,
                     bit::contact_lever, bit::pitch, bit::axial_damping, bit::torsional_damping)),
      key_table("string", motion_keys::table,
                rows(motion_keys::rotary_speed, motion_keys::rate_of_penetration,
                     motion_keys::weight_on_bit, motion_keys::weight_at_start,
                     motion_keys::torque_at_start)),
      key_table("string", rotate_time_keys::table,
                rows(rotate_time_keys::step, rotate_time_keys::duration)),
      key_table("string", out::table,
                rows(out::history_every, out::string_depths, out::string_profile_every))};
}

KeyTable body_table() {
  using namespace body_keys;
  return key_table("rotate", table,
                   rows(inertia, mesh, density, unit, unit_check, rotation_vector, attitude,
                        angular_velocity, check));
}

KeyTable cone_table() {
  using namespace cone_keys;
  return key_table("rotate", table,
                   rows(axis, axial_inertia, spin, angle, torque, external_torque, damping));
}

std::vector<KeyTable> load_tables() {
  using namespace load_keys;
  using namespace harmonic_keys;
  return {
      key_table("rotate", load_keys::table,
                rows(body_torque, space_torque, gravity_moment, gravity_arm, stiffness, damping)),
      key_table("rotate", harmonic_keys::table, rows(frame, amplitude, angular_frequency, phase)),
      key_table("rotate", sample_keys::table, rows(sample_keys::frame, sample_keys::file))};
}

std::vector<KeyTable> rotate_tables() {
  using namespace integrator_keys;
  return {key_table("rotate", title_keys::table, rows(title_keys::title)),
          key_table("rotate", table, rows(drift, drifts_per_step, order, velocity_torque)),
          key_table("rotate", rotate_time_keys::table,
                    rows(rotate_time_keys::step, rotate_time_keys::duration)),
          key_table("rotate", rotate_output_keys::table,
                    rows(rotate_output_keys::history_every, rotate_output_keys::checkpoint_every))};
}

}  // namespace

std::vector<KeyTable> all_tables() {
  std::vector<KeyTable> all{key_table("run", title_keys::table, rows(title_keys::title)),
                            key_table("run", bit_keys::table, rows(bit_keys::file)),
                            key_table("run", bit_keys::changes, rows(bit_keys::any))};
  const auto add = [&all](const std::vector<KeyTable>& tables) {
    all.insert(all.end(), tables.begin(), tables.end());
  };
  add(rock_tables());
  add({motion_table(), whirl_table(), tilt_table(), leg_table(), schedule_table()});
  add({time_table(), update_table(), maintenance_table(), measure_table()});
  add(force_tables());
  add(wear_tables());
  add(spalling_tables());
  add({string_table()});
  add(chain_tables_of("run"));
  add({wall_table(), rock_mount_table(), output_table()});
  add(string_tables());
  add(chain_tables_of("string"));
  add({body_table(), cone_table()});
  add(load_tables());
  add(rotate_tables());
  add(bit::bit_tables());
  return all;
}

}  // namespace tdbd::simulation
