#pragma once

#include <vector>

#include "rock/section/face_columns.hpp"
#include "rotation/screw.hpp"

namespace tdbd::rock {

/// X . v on the face: an affine function in its plane.
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

/// Columns of a face, `first` to before `end`, that are carried ahead together.
struct FaceStrip {
  std::size_t first, end;
  double ahead;  ///< s, time for which they are carried
};

/// Divides a face into strips so that the smallest speeds X . v of a strip's columns are within a
/// factor of 1.5. A strip is carried for the time lead / (its smallest speed), so that every point
/// of it moves at least `lead` (m) ahead, but for at most `longest_time` (s). Without a lead it is
/// not carried. No point of the face may move backwards, and at least one must move forwards.
void face_strips(const FaceColumns& face, const ForwardSpeed& v, const SpeedRange& range,
                 double lead, double longest_time, std::vector<FaceStrip>& strips);

/// The time in which the bit turns by `turn` (rad), s; infinite if it does not turn.
double time_of_turn(const rotation::Twist& twist, double turn);

}  // namespace tdbd::rock
