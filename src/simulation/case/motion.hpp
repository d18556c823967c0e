#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/field.hpp"
#include "core/types.hpp"
#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd {
class Config;
}

namespace tdbd::simulation {

struct RigLog;

/// drilling: forces move the bit (drive.hpp). As a prescribed motion, it follows its top.
enum class MotionKind { steady, whirl, legs, table, drilling };
enum class WhirlSense { forward, backward };

/// How the cones of a roller cone bit turn: each at a prescribed speed relative to the bit's, or as
/// determined by its contacts with rock (drive.hpp).
enum class ConeDrive { given, rolling };

/// The largest spring, damper, mass or load (SI). Products of larger ones are not finite.
inline constexpr double largest_constant = 1e16;
inline constexpr Range up_to_largest = Range::within(0.0, largest_constant);
inline constexpr Range above_zero_to_largest{
    .lo = 0.0, .hi = largest_constant, .ends = Range::Ends::open_lo};

/// Keys of [motion] that several readers use: of a number, of a table over time, of the log of a
/// rig, of a string.
namespace motion_keys {

inline constexpr QuantityKey rotary_speed{
    .name = "rotary_speed",
    .unit = "rad/s",
    .need = Need::required,
    .computed_default = "required, except legs and table",
    .range = Range::non_negative(),
    .meaning = "of the bit; drilling: of the top, or a table over time"};
inline constexpr QuantityKey rate_of_penetration{
    .name = "rate_of_penetration",
    .unit = "m/s",
    .need = Need::required,
    .computed_default = "required, except legs and table",
    .meaning = "of the bit; drilling: the top is lowered at this rate, or by a table over time",
    .usual = Range::within(0.0, 0.3)};
inline constexpr QuantityKey weight_on_bit{
    .name = "weight_on_bit",
    .unit = "N",
    .computed_default = "in place of rate_of_penetration",
    .range = up_to_largest,
    .meaning = "drilling: load of the top, or a table over time",
    .usual = Range::within(100.0, 3e6)};
inline constexpr QuantityKey weight_at_start{
    .name = "weight_at_start",
    .unit = "N",
    .fallback = 0.0,
    .range = up_to_largest,
    .meaning = "drilling: weight that the string carries at t = 0",
    .usual = Range::within(100.0, 3e6)};
inline constexpr QuantityKey torque_at_start{
    .name = "torque_at_start",
    .unit = "N m",
    .fallback = 0.0,
    .range = up_to_largest,
    .meaning = "drilling: torque that twists the string at t = 0"};

}  // namespace motion_keys

/// The centre of the bit circles the axis of the hole: forward with the rotation of the bit,
/// backward against it. The radius of the orbit increases from zero during `ramp`, so that the bit
/// starts in its hole. Thesis: 4.4.3.
struct Whirl {
  double radius = 0.0;     ///< m
  double frequency = 0.0;  ///< rad/s, positive
  WhirlSense sense = WhirlSense::backward;
  double ramp = 0.0;  ///< s

  static constexpr TableKey table{"motion.whirl", "kind whirl: the bit's centre circles the axis"};
  void visit(FieldVisitor& v) {
    v(radius, {.name = "radius",
               .unit = "m",
               .need = Need::required,
               .range = Range::non_negative(),
               .meaning = "of the centre's orbit",
               .usual = Range::within(0.0, 0.2)});
    v(frequency, {.name = "frequency",
                  .unit = "rad/s",
                  .need = Need::required,
                  .range = Range::non_negative(),
                  .meaning = "of the centre on its orbit",
                  .usual = Range::within(0.0, 300.0)});
    v(sense, {.name = "sense",
              .values = {{{"forward", WhirlSense::forward}, {"backward", WhirlSense::backward}}},
              .meaning = "with the bit's rotation or against it"});
    v(ramp, {.name = "ramp",
             .unit = "s",
             .computed_default = "one turn of the bit",
             .range = Range::non_negative(),
             .meaning = "time in which the orbit reaches its radius"});
  }
};

/// The axis of the bit leans by an angle from z of the hole towards an azimuth, which may precess:
/// forward with the bit, backward against it. The bit turns about its leaning axis; its origin is
/// that of an upright bit. The lean increases from zero during `ramp`. [+]
struct Tilt {
  double angle = 0.0;      ///< rad
  double azimuth = 0.0;    ///< rad about z from x at t = 0
  double frequency = 0.0;  ///< rad/s, positive
  WhirlSense sense = WhirlSense::forward;
  double ramp = 0.0;  ///< s

  static constexpr TableKey table{"motion.tilt", "kinds steady, whirl: the bit's axis leans"};
  void visit(FieldVisitor& v) {
    v(angle, {.name = "angle",
              .unit = "rad",
              .need = Need::required,
              .range = Range::within(0.0, 0.5),
              .meaning = "between the bit's axis and z"});
    v(azimuth,
      {.name = "azimuth", .unit = "rad", .meaning = "towards which the axis leans at t = 0"});
    v(frequency, {.name = "frequency",
                  .unit = "rad/s",
                  .range = Range::non_negative(),
                  .meaning = "of the precession of the azimuth",
                  .usual = Range::within(0.0, 300.0)});
    v(sense, {.name = "sense",
              .values = {{{"forward", WhirlSense::forward}, {"backward", WhirlSense::backward}}},
              .meaning = "of the precession: with the bit's rotation or against it"});
    v(ramp, {.name = "ramp",
             .unit = "s",
             .computed_default = "one turn of the bit",
             .range = Range::non_negative(),
             .meaning = "time in which the lean reaches its angle"});
  }
};

/// A piece of a motion at constant speeds: drilling, moving sideways, or pulling back.
struct Leg {
  double duration = 0.0;           ///< s
  Vec3 velocity_W = Vec3::Zero();  ///< m/s, of the bit's origin
  double rotary_speed = 0.0;       ///< rad/s about z

  static constexpr TableKey table{
      "motion.legs", "kind legs: a piece of the motion at constant speeds", Repeats::yes};
  void visit(FieldVisitor& v) {
    v(duration, {.name = "duration",
                 .unit = "s",
                 .need = Need::required,
                 .range = Range::positive(),
                 .meaning = "of the leg"});
    v(velocity_W,
      {.name = "velocity", .unit = "m/s", .meaning = "of the bit's origin, spatial frame"});
    v(rotary_speed, {.name = "rotary_speed", .unit = "rad/s", .meaning = "about z"});
  }
};

/// One row of a path: time, position of the bit's origin and rotation vector, spatial frame.
struct PathPoint {
  double time = 0.0;    ///< s
  Vec3 p_WB;            ///< m
  Vec3 rotation_WB;     ///< rad
  double turned = 0.0;  ///< rad about the bit's axis since the first row; set by sum_turns
  long line = 0;        ///< of the file; 0: none
};

/// Sets `turned`: between two rows, the component of the shortest turn along the bit's axis.
void sum_turns(std::vector<PathPoint>& path);

/// Returns the path of an upright bit along legs from a position, with the turns summed. Its rows
/// are at the ends of legs and in between, at most a quarter of a turn apart.
std::vector<PathPoint> path_of(const std::vector<Leg>& legs, const Vec3& start_W);

/// [motion.KEY]: a quantity over time.
struct ScheduleSettings {
  std::vector<double> times, values;
  dynamics::Interpolation between = dynamics::Interpolation::stepwise;

  static constexpr TableKey table{
      "motion.KEY", "rotary_speed, rate_of_penetration or weight_on_bit (KEY) over time: drilling"};
  /// `unit`: of the values.
  void visit(FieldVisitor& v, std::string_view unit = "KEY's unit") {
    v(times, {.name = "times", .unit = "s", .need = Need::required, .meaning = "ascending"});
    v(values, {.name = "values",
               .unit = unit,
               .need = Need::required,
               .meaning = "as many as times, in the unit of KEY"});
    v(between, {.name = "between",
                .values = {{{"stepwise", dynamics::Interpolation::stepwise},
                            {"linear", dynamics::Interpolation::linear}}},
                .meaning = "a staircase or ramps"});
  }
};

/// The motion of the top of the string of a bit that is moved by forces, and the initial state of
/// the string.
struct TopPlan {
  dynamics::TopDrive top;
  double expected_rate = 0.0;    ///< m/s
  double weight_at_start = 0.0;  ///< N, that the string carries at the start
  double torque_at_start = 0.0;  ///< N m, by which the string is twisted at the start
  dynamics::Schedule hook_load;  ///< N, from the log of a rig; empty: none

  void visit(FieldVisitor& v, dynamics::AxialMode axial = dynamics::AxialMode::load) {
    v.any(motion_keys::weight_on_bit);
    if (v.when(axial == dynamics::AxialMode::load)) {
      v(expected_rate, {.name = "expected_rate",
                        .unit = "m/s",
                        .meaning = "drilling with weight_on_bit: rate at which the bit and the "
                                   "upper end of its damper start",
                        .usual = Range::within(0.0, 0.3)});
      v(top.following_time,
        {.name = "rate_memory",
         .unit = "s",
         .computed_default = "one turn at the fastest rotary_speed",
         .range = Range::non_negative(),
         .meaning = "drilling with weight_on_bit: time in which the upper end of the axial damper "
                    "follows the bit's advance, so that the damper carries no part of the mean "
                    "weight. 0: the end moves at expected_rate"});
    }
    v(weight_at_start, motion_keys::weight_at_start);
    v(torque_at_start, motion_keys::torque_at_start);
  }
};

/// How the cones of a bit with a prescribed motion turn, in [motion].
struct ConeMotion {
  std::vector<double> speeds;  ///< relative to the bit's, one per cone; positive: rolling
  ConeDrive drive = ConeDrive::given;
  double memory = 0.0;  ///< s, only for rolling: how long a contact counts

  void visit(FieldVisitor& v, ConeDrive kind = ConeDrive::given) {
    if (v.when(kind == ConeDrive::given)) {
      v(speeds, {.name = "cone_speeds",
                 .need = Need::required,
                 .computed_default = "required with cones, unless drilling",
                 .meaning = "speed of each cone over the bit's, positive: rolling"});
    }
    if (v.when(kind == ConeDrive::rolling)) {
      v(drive, {.name = "cone_speeds",
                .values = {{{"rolling", ConeDrive::rolling}}},
                .computed_default = "in place of the list",
                .meaning = "cones turn as their contacts with the rock let them"});
      v(memory, {.name = "cone_memory",
                 .unit = "s",
                 .computed_default = "the time of 0.1 rad of the bit",
                 .range = Range::non_negative(),
                 .meaning = "rolling cones: how long a contact counts"});
    }
  }
};

/// The motion of the bit. The run starts at its pose at t = 0.
struct Motion {
  MotionKind kind = MotionKind::steady;
  double rotary_speed = 0.0;         ///< rad/s about +z
  double rate_of_penetration = 0.0;  ///< m/s along +z
  Vec3 start_W = Vec3::Zero();       ///< m, added to the position of a steady or whirling bit
  Whirl whirl;
  Tilt tilt;
  std::string path_file;        ///< only for motion along a table
  std::vector<PathPoint> path;  ///< ascending times, at least two rows, turns summed
  ConeMotion cones;
  TopPlan
      driven;  ///< only for drilling; rotary_speed and rate_of_penetration are those of its start

  static constexpr TableKey table{"motion", "how the bit moves"};
  void visit(FieldVisitor& v) {
    v(kind, {.name = "kind",
             .values = {{{"steady", MotionKind::steady},
                         {"whirl", MotionKind::whirl},
                         {"legs", MotionKind::legs},
                         {"table", MotionKind::table},
                         {"drilling", MotionKind::drilling}}},
             .meaning = "a prescribed motion (steady, whirl, legs, or a path from a file), or "
                        "drilling: forces move the bit"});
    if (v.when(kind != MotionKind::table)) {
      v(start_W, {.name = "start",
                  .unit = "m",
                  .meaning = "where the bit's origin starts; all kinds but table"});
    }
    if (v.when(kind == MotionKind::steady || kind == MotionKind::whirl)) {
      v(rotary_speed, motion_keys::rotary_speed);
      v(rate_of_penetration, motion_keys::rate_of_penetration);
    }
    if (v.when(kind == MotionKind::table)) {
      v.path(path_file,
             {.name = "file",
              .need = Need::required,
              .computed_default = "required with kind table",
              .meaning = "the path: CSV with time_s, x_m, y_m, z_m, rx_rad, ry_rad, rz_rad (place "
                         "of the bit's origin and rotation vector, spatial frame)"});
    }
  }
};

/// Whether the motion follows the rows of `path`.
inline bool has_path(const Motion& m) {
  return m.kind == MotionKind::table || m.kind == MotionKind::legs;
}

/// Returns the pose at time t. Between rows of a path the bit moves rigidly: its origin along the
/// chord, its rotation along the shortest turn. It is at rest before the first and after the last
/// row.
Pose pose_at(const Motion& motion, double t);

/// Returns the angle (rad) turned about the bit's axis since the start: the rotary speed times t,
/// or the sum of the turns of a path.
double angle_turned(const Motion& motion, double t);

/// Returns the angles of the cones about their Z, rad. Each is the speed of the cone times the turn
/// of the bit; a rolling cone turns against its Z (bit/cone/cone_frame.hpp).
std::vector<double> cone_angles(const Motion& motion, double t);

/// The position of the bit at an instant.
struct Place {
  Pose X_WB;            ///< bit in space
  double turned = 0.0;  ///< rad about the bit's axis since the start
  double rock_z = 0.0;  ///< m that the rock has moved along +z (eq. 2.2)

  template <class Archive>
  void serialize(Archive& a) {
    a(X_WB, turned, rock_z);
  }
};

/// Returns the bit in the frame of the rock, in which the surface of the rock is stored.
inline Pose over_rock(const Place& place) {
  Pose X_RB = place.X_WB;
  X_RB.p.z() -= place.rock_z;
  return X_RB;
}

/// Returns the place at time t (s) along a prescribed motion.
inline Place place_at(const Motion& motion, double t) {
  return {pose_at(motion, t), angle_turned(motion, t), 0.0};
}

/// Reads a path: CSV with the columns time_s, x_m, y_m, z_m, rx_rad, ry_rad, rz_rad (position of
/// the bit's origin and rotation vector, spatial frame). Throws InputError with the line of the
/// file for a missing column, NaN, fewer than two rows, or times that do not ascend.
std::vector<PathPoint> read_path_table(const std::string& path);

/// Reads [motion]. Records mistakes, including those in the file of a path. `bit`: for its cones;
/// without parts if it could not be read. `log`: the speeds and the hook load of a rig, which
/// replace keys.
Motion read_motion(Config& whole, const bit::Bit& bit, const RigLog& log);

}  // namespace tdbd::simulation
