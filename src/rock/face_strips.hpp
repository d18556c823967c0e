#pragma once

#include <vector>

#include "rock/face_outline.hpp"
#include "rock/twist.hpp"

namespace tdbd::rock {

struct RimEdge {
  Vec2 from, to;  ///< m, frame F
};

/// A part of a face that is carried ahead as one piece.
struct FaceStrip {
  ConvexPolygon outline_F;
  Vec2 lo_F, hi_F;             ///< m, its box
  std::vector<RimEdge> rim_F;  ///< the face's own edge in it, without the strip's cuts
  double ahead = 0.0;          ///< s, for how long it is carried
};

/// The forward going part of a face in strips, from its fastest point on: in strip k the speed
/// X . v lies in [q^-(k+1), q^-k] of the fastest, q = 1.5, and it is carried for lead / (least
/// speed in it). The last strip goes down to the slowest point, or to speed 0 once the bit would
/// turn by more than largest_turn (rad) meanwhile.
std::vector<FaceStrip> face_strips(const FaceOutline& face, const Twist& twist, double lead,
                                   double largest_turn);

}  // namespace tdbd::rock
