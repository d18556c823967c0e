#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "dynamics/drilling/drilling_system.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/case/run_settings.hpp"
#include "simulation/case/string_settings.hpp"
#include "string/statics.hpp"

namespace tdbd::simulation {

/// [string] of a bit that drills: springs, dampers and masses between the bit and the top drive.
struct LumpedString {
  double mass = 0.0, bending_inertia = 0.0, torsional_inertia = 0.0;
  double lateral_stiffness = 0.0, axial_stiffness = 0.0;
  double bending_stiffness = 0.0, torsional_stiffness = 0.0;
  double lateral_damping = 0.0, axial_damping = 0.0;
  double bending_damping = 0.0, torsional_damping = 0.0;
  dynamics::DamperEnd dampers_to = dynamics::DamperEnd::top;
  double bearing_damping = 0.0;
  double attachment_height = 0.0;
  double gravity = 9.80665;

  static constexpr TableKey table{"string", "drilling: the drill string, from the bit to the top"};
  void visit(FieldVisitor& v) {
    v(mass, {.name = "mass",
             .unit = "kg",
             .range = up_to_largest,
             .meaning = "of string that moves with the bit"});
    v(bending_inertia, {.name = "bending_inertia",
                        .unit = "kg m2",
                        .range = up_to_largest,
                        .meaning = "of that string, about the horizontal axes"});
    v(torsional_inertia, {.name = "torsional_inertia",
                          .unit = "kg m2",
                          .range = up_to_largest,
                          .meaning = "of that string, about the bit's axis"});
    v(lateral_stiffness, {.name = "lateral_stiffness",
                          .unit = "N/m",
                          .range = up_to_largest,
                          .meaning = "against sideways displacement"});
    v(axial_stiffness, {.name = "axial_stiffness",
                        .unit = "N/m",
                        .range = up_to_largest,
                        .meaning = "against displacement along z; must be given if the top is "
                                   "lowered at a rate and has no damper"});
    v(bending_stiffness, {.name = "bending_stiffness",
                          .unit = "N m/rad",
                          .range = up_to_largest,
                          .meaning = "against leaning"});
    v(torsional_stiffness, {.name = "torsional_stiffness",
                            .unit = "N m/rad",
                            .range = up_to_largest,
                            .meaning = "against twist relative to the top; must be given if that "
                                       "turns the bit and no damper does"});
    visit_damping(v);
    v(dampers_to,
      {.name = "dampers_to",
       .values = {{{"top", dynamics::DamperEnd::top}, {"space", dynamics::DamperEnd::space}}},
       .meaning = "reference of the dampers: the motion of the top, or rest"});
    v(bearing_damping, {.name = "bearing_damping",
                        .unit = "N m s/rad",
                        .range = up_to_largest,
                        .meaning = "of the cones' bearings"});
    v(attachment_height,
      {.name = "attachment_height",
       .unit = "m",
       .computed_default = "the bit's centre of mass",
       .range = Range::within(-100.0, 100.0),
       .meaning = "height above the bit's origin of the point at which lateral and axial springs, "
                  "dampers and the load act; 0: the nose. A bit that hangs from a point below its "
                  "centre of mass topples unless its bending stiffness prevents it"});
    v(gravity, {.name = "gravity",
                .unit = "m/s2",
                .range = Range::within(0.0, 100.0),
                .meaning = "along +z"});
  }
  void visit_damping(FieldVisitor& v) {
    v(lateral_damping, {.name = "lateral_damping",
                        .unit = "N s/m",
                        .range = up_to_largest,
                        .meaning = "of sideways motion"});
    v(axial_damping, {.name = "axial_damping",
                      .unit = "N s/m",
                      .range = up_to_largest,
                      .meaning = "of motion along z"});
    v(bending_damping, {.name = "bending_damping",
                        .unit = "N m s/rad",
                        .range = up_to_largest,
                        .meaning = "of leaning"});
    v(torsional_damping, {.name = "torsional_damping",
                          .unit = "N m s/rad",
                          .range = up_to_largest,
                          .meaning = "of rotation"});
  }
};

/// What confines the bit to its hole.
enum class WallModel {
  ring,  ///< a circle that a ring of the bit touches: casing, or a hole that does not change
  rock,  ///< the rock that the bit cuts; the law of friction acts on gage pads
};

/// [wall].
struct WallSettings {
  WallModel model = WallModel::ring;
  dynamics::Wall wall;
  double ring_height = 0.0;  ///< of the ring above the bit's origin, m

  static constexpr TableKey table{
      "wall",
      "drilling: the wall of the hole: a circle that a ring of the bit touches, or the rock"};
  void visit(FieldVisitor& v) {
    visit_model(v);
    const Refusal of_ring{"a key of a ring",
                          "wall.model = \"ring\", or only friction and slip_speed"};
    v.only(model == WallModel::ring, of_ring, [&] {
      v(wall.stiffness, {.name = "stiffness",
                         .unit = "N/m",
                         .need = Need::required,
                         .computed_default = "required with model ring",
                         .range = above_zero_to_largest,
                         .meaning = "of the wall"});
      v(wall.clearance, {.name = "clearance",
                         .unit = "m",
                         .need = Need::required,
                         .computed_default = "required with model ring",
                         .range = Range::within(0.0, 10.0),
                         .meaning = "radius of the hole minus that of the ring"});
      v(wall.ring_radius, {.name = "ring_radius",
                           .unit = "m",
                           .computed_default = "the bit's gage radius",
                           .range = {0.0, 10.0, Range::Ends::open_lo},
                           .meaning = "of the ring"});
      v(ring_height, {.name = "ring_height",
                      .unit = "m",
                      .range = Range::within(-100.0, 100.0),
                      .meaning = "of the ring above the bit's origin"});
      v(wall.restitution, {.name = "restitution",
                           .range = Range::within(0.0, 1.0),
                           .meaning = "speed after an impact over that before it"});
    });
    if (v.when(model == WallModel::ring)) visit_friction(v);
  }
  void visit_model(FieldVisitor& v) {
    v(model,
      {.name = "model",
       .values = {{{"ring", WallModel::ring}, {"rock", WallModel::rock}}},
       .meaning =
           "ring: a circle of fixed clearance, which does not depend on what the bit cuts. rock: "
           "gage pads follow the law \"friction\" at the strength of the rock, unless "
           "[forces.gage_pad] gives another law; of the keys below, friction and slip_speed"});
  }
  void visit_friction(FieldVisitor& v) {
    v(wall.friction, {.name = "friction",
                      .range = Range::within(0.0, 10.0),
                      .meaning = "Coulomb's coefficient along the wall"});
    v(wall.slip_speed, {.name = "slip_speed",
                        .unit = "m/s",
                        .range = Range::within(0.0, 100.0),
                        .meaning = "speed below which friction decreases; 0: none"});
  }
};

/// [rock_mount].
struct RockMountSettings {
  dynamics::RockMount rock;

  static constexpr TableKey table{"rock_mount", "drilling: rock that moves along z (eq. 2.2)"};
  void visit(FieldVisitor& v) {
    v(rock.mass, {.name = "mass",
                  .unit = "kg",
                  .need = Need::required,
                  .range = above_zero_to_largest,
                  .meaning = "of the rock"});
    v(rock.stiffness, {.name = "stiffness",
                       .unit = "N/m",
                       .range = up_to_largest,
                       .meaning = "of the mount of the rock"});
    v(rock.damping, {.name = "damping",
                     .unit = "N s/m",
                     .range = up_to_largest,
                     .meaning = "of the mount of the rock"});
  }
};

/// The bit, the string, the wall and the mount of the rock for a bit that is moved by forces, with
/// their initial state (thesis: eqs. 2.1 to 2.3).
struct DrillingPlan {
  dynamics::DrillingSystem system;
  dynamics::DrillingState start;
  // For a string on a chain.
  StringPlan string;
  string::ChainState chain;           ///< at the start
  string::SteadyMotion start_motion;  ///< of that chain
};

/// Reads [string], [wall] and [rock_mount], and combines bit and string: the mass of the string is
/// at the centre of mass of the bit. Records mistakes.
DrillingPlan read_drilling(Config& whole, const bit::Bit& bit, const Motion& m, double step,
                           std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
