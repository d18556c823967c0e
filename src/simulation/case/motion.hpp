#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"
#include "dynamics/drilling/drilling_system.hpp"
#include "simulation/case/motion_keys.hpp"

namespace tdbd::simulation {

/// The bit's centre circles the hole's axis: forward turns with the bit, backward against it.
/// The orbit grows from nothing over `ramp`, so that the bit starts in its hole. Thesis: 4.4.3.
struct Whirl {
  double radius = 0.0;     ///< m
  double frequency = 0.0;  ///< rad/s, positive
  WhirlSense sense = *whirl_keys::sense.fallback;
  double ramp = 0.0;  ///< s
};

/// The bit's axis leans by an angle from the hole's z towards an azimuth, which may precess:
/// forward with the bit, backward against it. The bit turns about its leaning axis; its origin
/// stays where an upright bit has it. The lean grows from nothing over `ramp`. Ours.
struct Tilt {
  double angle = 0.0;      ///< rad
  double azimuth = 0.0;    ///< rad about z from x at t = 0
  double frequency = 0.0;  ///< rad/s, positive
  WhirlSense sense = *tilt_keys::sense.fallback;
  double ramp = 0.0;  ///< s
};

/// A piece of a motion at constant speeds: drilling, going sideways, pulling back.
struct Leg {
  double duration = 0.0;           ///< s
  Vec3 velocity_W = Vec3::Zero();  ///< m/s, of the bit's origin
  double rotary_speed = 0.0;       ///< rad/s about z
};

/// One row of a path: time, place of the bit's origin and rotation vector, spatial frame.
struct PathPoint {
  double time = 0.0;    ///< s
  Vec3 p_WB;            ///< m
  Vec3 rotation_WB;     ///< rad
  double turned = 0.0;  ///< rad about the bit's axis since the first row; sum_turns fills it
  long line = 0;        ///< of the file that it comes from; 0: none
};

/// Fills `turned`: between two rows, the shortest turn's component along the bit's axis.
void sum_turns(std::vector<PathPoint>& path);

/// The path of an upright bit along legs from a place, turns summed: rows at the ends of legs and
/// in between, a quarter of a turn apart or less.
std::vector<PathPoint> path_of(const std::vector<Leg>& legs, const Vec3& start_W);

/// What moves the top of the string of a bit that drills by itself, and how the string starts.
struct TopPlan {
  dynamics::TopDrive top;
  double weight_at_start = 0.0;  ///< N, that the string carries already
  double torque_at_start = 0.0;  ///< N m, that winds it up already
  dynamics::Schedule hook_load;  ///< N, from the log of a rig; empty: none
};

/// The motion of the bit. Its pose at t = 0 is the start.
struct Motion {
  MotionKind kind = *motion_keys::kind.fallback;
  double rotary_speed = 0.0;         ///< rad/s about +z
  double rate_of_penetration = 0.0;  ///< m/s along +z
  Vec3 start_W = Vec3::Zero();       ///< m, added to the place of a steady or a whirling bit
  Whirl whirl;
  Tilt tilt;
  std::string path_file;            ///< table only
  std::vector<PathPoint> path;      ///< rising times, at least two, turns summed
  std::vector<double> cone_speeds;  ///< over the bit's, one for each cone; positive: rolling
  ConeDrive cone_drive = ConeDrive::given;
  double cone_memory = 0.0;  ///< s, rolling only: how long a contact counts
  TopPlan driven;  ///< drilling only; rotary_speed and rate_of_penetration are its start's
};

/// Whether the motion goes along rows of `path`.
inline bool has_path(const Motion& m) {
  return m.kind == MotionKind::table || m.kind == MotionKind::legs;
}

/// Pose at time t. Between rows of a path the bit moves rigidly: its origin on the chord, its
/// rotation along the shortest turn. Before the first and after the last row it rests there.
Pose pose_at(const Motion& motion, double t);

/// Angle turned about the bit's axis since the start, rad: rotary speed times t, or along a path
/// the sum of its turns.
double angle_turned(const Motion& motion, double t);

/// Angles of the cones about their Z, rad: each turns by its speed times what the bit turned, and
/// a cone that rolls turns against its Z (bit/cone/cone_frame.hpp).
std::vector<double> cone_angles(const Motion& motion, double t);

/// Where the bit is at an instant.
struct Place {
  Pose X_WB;            ///< bit in space
  double turned = 0.0;  ///< rad about the bit's axis since the start
  double rock_z = 0.0;  ///< m that the rock has moved along +z (eq. 2.2)

  template <class Archive>
  void serialize(Archive& a) {
    a(X_WB, turned, rock_z);
  }
};

/// The bit in the frame of the rock, in which its surface is kept.
inline Pose over_rock(const Place& place) {
  Pose X_RB = place.X_WB;
  X_RB.p.z() -= place.rock_z;
  return X_RB;
}

/// The place at time t (s) along a prescribed motion.
inline Place place_at(const Motion& motion, double t) {
  return {pose_at(motion, t), angle_turned(motion, t), 0.0};
}

}  // namespace tdbd::simulation
