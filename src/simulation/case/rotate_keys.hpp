#pragma once

#include "core/config/key.hpp"
#include "dynamics/gyrostat.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/loads.hpp"

/// The keys of a case of rotation alone, which has a table [body] (thesis: 5.1 to 5.5).
namespace tdbd::simulation {

namespace body_keys {

inline constexpr TableKey table{"body", "the body, and how it starts"};

inline constexpr MatrixKey inertia{.name = "inertia",
                                   .unit = "kg m2",
                                   .usual = "required without mesh",
                                   .meaning = "of body and cones locked together, bit frame"};
inline constexpr PathKey mesh{
    .name = "mesh",
    .usual = "in place of inertia",
    .meaning =
        "a closed mesh of one density: its inertia about its centre of mass, along the axes "
        "of its file"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .usual = "required with mesh",
                                     .range = Range::positive(),
                                     .meaning = "of the body"};
inline constexpr QuantityKey unit{.name = "unit",
                                  .unit = "m",
                                  .fallback = 1e-3,
                                  .range = Range::positive(),
                                  .meaning = "with mesh: length of its file's unit"};
inline constexpr FlagKey unit_check{
    .name = "unit_check",
    .fallback = true,
    .meaning = "with mesh: whether to refuse a mesh that is not 10 mm to 20 m long"};
inline constexpr VectorKey rotation_vector{.name = "rotation_vector",
                                           .unit = "rad",
                                           .fallback = {{0.0, 0.0, 0.0}},
                                           .meaning = "attitude at the start, bit to space"};
inline constexpr MatrixKey attitude{.name = "attitude",
                                    .usual = "in place of rotation_vector",
                                    .meaning = "attitude at the start as a rotation matrix"};
inline constexpr VectorKey angular_velocity{.name = "angular_velocity",
                                            .unit = "rad/s",
                                            .fallback = {{0.0, 0.0, 0.0}},
                                            .meaning = "at the start, bit frame"};
inline constexpr ChoiceKey<dynamics::InertiaCheck> check{
    .name = "check",
    .values = {{{"on", dynamics::InertiaCheck::on}, {"off", dynamics::InertiaCheck::off}}},
    .fallback = dynamics::InertiaCheck::on,
    .meaning = "whether to refuse an inertia that no body can have"};

}  // namespace body_keys

namespace cone_keys {

inline constexpr TableKey table{"cones", "a cone that turns about an axis fixed in the body",
                                Repeats::yes};

inline constexpr VectorKey axis{.name = "axis", .meaning = "direction of the axis, bit frame"};
inline constexpr QuantityKey axial_inertia{.name = "axial_inertia",
                                           .unit = "kg m2",
                                           .range = Range::positive(),
                                           .meaning = "about the axis"};
inline constexpr QuantityKey spin{.name = "spin",
                                  .unit = "rad/s",
                                  .fallback = 0.0,
                                  .meaning = "at the start, seen from the body"};
inline constexpr QuantityKey angle{
    .name = "angle", .unit = "rad", .fallback = 0.0, .meaning = "about the axis at the start"};
inline constexpr QuantityKey torque{
    .name = "torque",
    .unit = "N m",
    .fallback = 0.0,
    .meaning = "from the body about the axis: it changes the cone's momentum alone"};
inline constexpr QuantityKey external_torque{
    .name = "external_torque",
    .unit = "N m",
    .fallback = 0.0,
    .meaning = "from outside about the axis: it changes the total momentum too"};
inline constexpr QuantityKey damping{.name = "damping",
                                     .unit = "N m s/rad",
                                     .fallback = 0.0,
                                     .range = Range::non_negative(),
                                     .meaning = "of the bearing"};

}  // namespace cone_keys

namespace load_keys {

inline constexpr TableKey table{"load", "the torques on the body"};

inline constexpr VectorKey body_torque{.name = "body_torque",
                                       .unit = "N m",
                                       .fallback = {{0.0, 0.0, 0.0}},
                                       .meaning = "fixed in the body"};
inline constexpr VectorKey space_torque{.name = "space_torque",
                                        .unit = "N m",
                                        .fallback = {{0.0, 0.0, 0.0}},
                                        .meaning = "fixed in space"};
inline constexpr QuantityKey gravity_moment{
    .name = "gravity_moment",
    .unit = "N m",
    .fallback = 0.0,
    .meaning = "of the potential V = gravity_moment ez . R gravity_arm"};
inline constexpr VectorKey gravity_arm{
    .name = "gravity_arm",
    .fallback = {{0.0, 0.0, 1.0}},
    .meaning = "direction from the fixed point to the centre of mass, bit frame"};
inline constexpr VectorKey stiffness{
    .name = "stiffness",
    .unit = "N m/rad",
    .fallback = {{0.0, 0.0, 0.0}},
    .meaning = "by axis of space, none negative; about z on the unwrapped twist"};
inline constexpr VectorKey damping{.name = "damping",
                                   .unit = "N m s/rad",
                                   .fallback = {{0.0, 0.0, 0.0}},
                                   .meaning = "by axis of space, none negative"};

}  // namespace load_keys

namespace harmonic_keys {

inline constexpr TableKey table{
    "load.harmonics", "a torque amplitude cos(angular_frequency t + phase)", Repeats::yes};

inline constexpr ChoiceKey<dynamics::TorqueFrame> frame{
    .name = "frame",
    .values = {{{"body", dynamics::TorqueFrame::body}, {"space", dynamics::TorqueFrame::space}}},
    .fallback = dynamics::TorqueFrame::body,
    .meaning = "in which the torque is fixed"};
inline constexpr VectorKey amplitude{
    .name = "amplitude", .unit = "N m", .meaning = "of the torque"};
inline constexpr QuantityKey angular_frequency{.name = "angular_frequency",
                                               .unit = "rad/s",
                                               .fallback = 0.0,
                                               .range = Range::non_negative(),
                                               .meaning = "0: constant"};
inline constexpr QuantityKey phase{
    .name = "phase", .unit = "rad", .fallback = 0.0, .meaning = "at t = 0"};

}  // namespace harmonic_keys

namespace sample_keys {

inline constexpr TableKey table{
    "load.samples", "a torque from a file, linear between rows, held outside", Repeats::yes};

inline constexpr auto frame = harmonic_keys::frame;
inline constexpr PathKey file{.name = "file",
                              .meaning = "CSV with the columns time_s, x, y, z, in N m"};

}  // namespace sample_keys

namespace integrator_keys {

inline constexpr TableKey table{"integrator", "how the rotation is integrated"};

inline constexpr ChoiceKey<dynamics::Drift> drift{
    .name = "drift",
    .values = {{{"split", dynamics::Drift::split},
                {"three-axis", dynamics::Drift::three_axis},
                {"lie-midpoint", dynamics::Drift::lie_midpoint},
                {"lie-mean", dynamics::Drift::lie_mean}}},
    .fallback = dynamics::Integrator{}.drift,
    .meaning = "how the body coasts between kicks; lie-midpoint is the thesis's, reconstructed"};
inline constexpr IntegerKey drifts_per_step{.name = "drifts_per_step",
                                            .fallback = dynamics::Integrator{}.drifts_per_step,
                                            .lo = 1,
                                            .hi = 1000,
                                            .meaning = "the thesis's form has 2"};
inline constexpr IntegerKey order{.name = "order",
                                  .fallback = dynamics::Integrator{}.order,
                                  .lo = 2,
                                  .hi = 8,
                                  .meaning = "of the step: 2, 4, 6 or 8"};
inline constexpr ChoiceKey<dynamics::VelocityTorque> velocity_torque{
    .name = "velocity_torque",
    .values = {{{"predicted", dynamics::VelocityTorque::predicted},
                {"symmetric", dynamics::VelocityTorque::symmetric}}},
    .usual = "predicted for order 2, else symmetric",
    .meaning = "how the closing kick evaluates damping; only symmetric composes to a higher order"};

}  // namespace integrator_keys

namespace rotate_time_keys {

inline constexpr TableKey table{"time", "how long, and in which steps"};

inline constexpr QuantityKey step{
    .name = "step",
    .unit = "s",
    .range = Range::positive(),
    .meaning = "time step; the next shorter one that fits the duration is used"};
inline constexpr QuantityKey duration{
    .name = "duration", .unit = "s", .range = Range::positive(), .meaning = "of the run"};

}  // namespace rotate_time_keys

namespace rotate_output_keys {

inline constexpr TableKey table{"output", "what is recorded"};

inline constexpr IntegerKey history_every{.name = "history_every",
                                          .usual = "at most 10 000 rows",
                                          .lo = 1,
                                          .hi = 1'000'000'000'000,
                                          .meaning = "steps between rows of the history"};
inline constexpr IntegerKey checkpoint_every{
    .name = "checkpoint_every",
    .usual = "as often as costs less than 1 % of the time",
    .hi = 1'000'000'000'000,
    .meaning = "steps between checkpoints, from which `tdbd rotate --resume` goes on; 0: none"};

}  // namespace rotate_output_keys

}  // namespace tdbd::simulation
