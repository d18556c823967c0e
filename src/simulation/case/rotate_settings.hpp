#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "core/config/field.hpp"
#include "dynamics/gyrostat.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/loads.hpp"
#include "mesh/files/length_unit.hpp"

/// The settings of a case of rotation without rock, which has a table [body] (thesis: 5.1 to 5.5).
namespace tdbd::simulation {

/// [body]: the body and its initial state.
struct BodySettings {
  Mat3 inertia = Mat3::Identity();
  std::string mesh;
  double density = 0.0, unit = 1e-3;
  bool unit_check = true;
  Vec3 rotation_vector = Vec3::Zero();
  Mat3 attitude = Mat3::Identity();
  Vec3 angular_velocity = Vec3::Zero();
  dynamics::InertiaCheck check = dynamics::InertiaCheck::on;

  static constexpr TableKey table{"body", "the body and its initial state"};
  void visit(FieldVisitor& v) {
    const bool is_mesh = v.gives("mesh"), is_matrix = v.gives("attitude");
    v.only(!is_mesh, {"mesh as well", "one of the two"}, [&] {
      v(inertia, {.name = "inertia",
                  .unit = "kg m2",
                  .need = Need::required,
                  .computed_default = "required without mesh",
                  .meaning = "of body and cones locked together, bit frame"});
    });
    if (v.when(is_mesh)) {
      v.path(mesh, {.name = "mesh",
                    .computed_default = "in place of inertia",
                    .meaning = "a closed mesh of one density: its inertia about its centre of "
                               "mass, along the axes of its file"});
      v(density, {.name = "density",
                  .unit = "kg/m3",
                  .need = Need::required,
                  .computed_default = "required with mesh",
                  .range = Range::positive(),
                  .meaning = "of the body"});
      unit = tdbd::mesh::unit_or(mesh, unit);
      v(unit, {.name = "unit",
               .unit = "m",
               .computed_default = "the unit that the file states, otherwise 1 mm",
               .range = Range::positive(),
               .meaning = "with mesh: length of its file's unit"});
      v(unit_check,
        {.name = "unit_check",
         .meaning = "with mesh: whether to refuse a mesh that is not 10 mm to 20 m long"});
    }
    const Need need_of_vector = is_matrix ? Need::optional : Need::defaulted;
    v(rotation_vector, {.name = "rotation_vector",
                        .unit = "rad",
                        .need = need_of_vector,
                        .meaning = "attitude at the start, bit to space"});
    if (v.when(is_matrix)) {
      v(attitude, {.name = "attitude",
                   .computed_default = "in place of rotation_vector",
                   .meaning = "attitude at the start as a rotation matrix"});
    }
    v(angular_velocity,
      {.name = "angular_velocity", .unit = "rad/s", .meaning = "at the start, bit frame"});
    v(check,
      {.name = "check",
       .values = {{{"on", dynamics::InertiaCheck::on}, {"off", dynamics::InertiaCheck::off}}},
       .meaning = "whether to reject an inertia that is physically impossible"});
  }
};

/// [[cones]]: a cone that turns about an axis fixed in the body.
struct ConeSettings {
  dynamics::Cone cone;
  double spin = 0.0, angle = 0.0;  ///< at the start, rad/s, rad
  dynamics::ConeLoad load;

  static constexpr TableKey table{"cones", "a cone that turns about an axis fixed in the body",
                                  Repeats::yes};
  void visit(FieldVisitor& v) {
    v(cone.axis_B,
      {.name = "axis", .need = Need::required, .meaning = "direction of the axis, bit frame"});
    v(cone.axial_inertia, {.name = "axial_inertia",
                           .unit = "kg m2",
                           .need = Need::required,
                           .range = Range::positive(),
                           .meaning = "about the axis"});
    v(spin, {.name = "spin", .unit = "rad/s", .meaning = "at the start, relative to the body"});
    v(angle, {.name = "angle", .unit = "rad", .meaning = "about the axis at the start"});
    v(load.internal,
      {.name = "torque",
       .unit = "N m",
       .meaning = "from the body about the axis: it changes only the momentum of the cone"});
    v(load.external,
      {.name = "external_torque",
       .unit = "N m",
       .meaning = "from outside about the axis: it also changes the total momentum"});
    v(load.damping, {.name = "damping",
                     .unit = "N m s/rad",
                     .range = Range::non_negative(),
                     .meaning = "of the bearing"});
  }
};

/// [load]: the torques on the body.
struct LoadSettings {
  dynamics::Loads loads;

  static constexpr TableKey table{"load", "the torques on the body"};
  void visit(FieldVisitor& v) {
    v(loads.body_torque_B, {.name = "body_torque", .unit = "N m", .meaning = "fixed in the body"});
    v(loads.space_torque_W, {.name = "space_torque", .unit = "N m", .meaning = "fixed in space"});
    v(loads.gravity_moment, {.name = "gravity_moment",
                             .unit = "N m",
                             .meaning = "of the potential V = gravity_moment ez . R gravity_arm"});
    v(loads.gravity_arm_B,
      {.name = "gravity_arm",
       .meaning = "direction from the fixed point to the centre of mass, bit frame"});
    v(loads.stiffness_W,
      {.name = "stiffness",
       .unit = "N m/rad",
       .meaning = "by axis of space, none negative; about z on the unwrapped twist"});
    v(loads.damping_W,
      {.name = "damping", .unit = "N m s/rad", .meaning = "by axis of space, none negative"});
  }
};

inline constexpr ChoiceKey<dynamics::TorqueFrame> torque_frame{
    .name = "frame",
    .values = {{{"body", dynamics::TorqueFrame::body}, {"space", dynamics::TorqueFrame::space}}},
    .meaning = "in which the torque is fixed"};

/// [[load.harmonics]].
struct HarmonicSettings {
  dynamics::HarmonicTorque torque;

  static constexpr TableKey table{
      "load.harmonics", "a torque amplitude cos(angular_frequency t + phase)", Repeats::yes};
  void visit(FieldVisitor& v) {
    v(torque.frame, torque_frame);
    v(torque.amplitude,
      {.name = "amplitude", .unit = "N m", .need = Need::required, .meaning = "of the torque"});
    v(torque.angular_frequency, {.name = "angular_frequency",
                                 .unit = "rad/s",
                                 .range = Range::non_negative(),
                                 .meaning = "0: constant"});
    v(torque.phase, {.name = "phase", .unit = "rad", .meaning = "at t = 0"});
  }
};

/// [[load.samples]].
struct SampleSettings {
  dynamics::TorqueFrame frame = dynamics::TorqueFrame::body;
  std::string file;

  static constexpr TableKey table{
      "load.samples", "a torque from a file, linear between rows, constant outside", Repeats::yes};
  void visit(FieldVisitor& v) {
    v(frame, torque_frame);
    v.path(file, {.name = "file",
                  .need = Need::required,
                  .meaning = "CSV with the columns time_s, x, y, z, in N m"});
  }
};

/// [integrator]: how the rotation is integrated.
struct IntegratorSettings {
  dynamics::Integrator integrator;

  static constexpr std::array<ChoiceKey<dynamics::Drift>::Named, 8> drifts{
      {{"split", dynamics::Drift::split},
       {"three-axis", dynamics::Drift::three_axis},
       {"lie-midpoint", dynamics::Drift::lie_midpoint},
       {"lie-mean", dynamics::Drift::lie_mean}}};

  static constexpr TableKey table{"integrator", "how the rotation is integrated"};
  void visit(FieldVisitor& v) {
    dynamics::Integrator& i = integrator;
    v(i.drift, {.name = "drift",
                .values = drifts,
                .meaning = "how the body coasts between kicks; lie-midpoint is the thesis's, "
                           "reconstructed"});
    v(i.drifts_per_step,
      {.name = "drifts_per_step", .lo = 1, .hi = 1000, .meaning = "the thesis's form has 2"});
    v(i.order, {.name = "order", .lo = 2, .hi = 8, .meaning = "of the step: 2, 4, 6 or 8"});
    // Only the symmetric treatment allows compositions of higher order.
    i.velocity_torque =
        i.order == 2 ? dynamics::VelocityTorque::predicted : dynamics::VelocityTorque::symmetric;
    v(i.velocity_torque,
      {.name = "velocity_torque",
       .values = {{{"predicted", dynamics::VelocityTorque::predicted},
                   {"symmetric", dynamics::VelocityTorque::symmetric}}},
       .computed_default = "predicted for order 2, else symmetric",
       .meaning = "how the closing kick evaluates damping; only symmetric allows a higher order"});
  }
};

/// [time] of a rotation, or of a string without rock.
struct RotateTimeSettings {
  double step = 0.0, duration = 0.0;

  static constexpr TableKey table{"time", "how long, and in which steps"};
  void visit(FieldVisitor& v) {
    v(step, {.name = "step",
             .unit = "s",
             .need = Need::required,
             .range = Range::positive(),
             .meaning = "time step; the next shorter one that fits the duration is used"});
    v(duration, {.name = "duration",
                 .unit = "s",
                 .need = Need::required,
                 .range = Range::positive(),
                 .meaning = "of the run"});
  }
};

/// Steps: 1e12, or what fits if a long has 32 bits, as in browsers.
inline constexpr long most_steps_between =
    std::min(1'000'000'000'000LL, static_cast<long long>(std::numeric_limits<long>::max()));

/// [output] of a rotation.
struct RotateOutput {
  long history_every = 1;
  long checkpoint_every = -1;  ///< negative: chosen so that it takes less than 1 % of the time

  static constexpr TableKey table{"output", "what is recorded"};
  void visit(FieldVisitor& v) {
    v(history_every, {.name = "history_every",
                      .computed_default = "at most 10 000 rows",
                      .lo = 1,
                      .hi = most_steps_between,
                      .meaning = "steps between rows of the history"});
    v(checkpoint_every,
      {.name = "checkpoint_every",
       .need = Need::optional,
       .computed_default = "so that they take less than 1 % of the time",
       .hi = most_steps_between,
       .meaning = "steps between checkpoints, from which `tdbd rotate --resume` resumes; 0: none"});
  }
};

}  // namespace tdbd::simulation
