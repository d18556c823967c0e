#pragma once

#include <vector>

#include "rock/section/face_columns.hpp"
#include "rotation/screw.hpp"

namespace tdbd::rock {

/// X . v on the face: affine in its plane.
struct ForwardSpeed {
  double at_origin;  ///< m/s
  Vec2 gradient;     ///< 1/s

  double operator()(const Vec2& x_F) const { return at_origin + gradient.dot(x_F); }
};

/// Over a face, m/s.
struct SpeedRange {
  double slowest, fastest;
};

ForwardSpeed forward_speed(const Pose& X_BF, const rotation::Twist& twist);

/// Columns of a face that are carried ahead together: `first` to before `end`.
struct FaceStrip {
  std::size_t first, end;
  double ahead;  ///< s, for how long
};

/// Divides a face into strips such that the least speeds X . v of a strip's columns are within a
/// factor of 1.5. A strip is carried for lead / (its least speed), so that every point of it comes
/// at least `lead` (m) ahead, but never for longer than `longest_time` (s), and without a lead not
/// at all. No point of the face may go backwards, and at least one must go forwards.
void face_strips(const FaceColumns& face, const ForwardSpeed& v, const SpeedRange& range,
                 double lead, double longest_time, std::vector<FaceStrip>& strips);

/// The time in which the bit turns by `turn` (rad), s; infinite if it does not turn.
double time_of_turn(const rotation::Twist& twist, double turn);

}  // namespace tdbd::rock
