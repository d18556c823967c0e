#pragma once

#include "rock/cut/cutting_bit.hpp"

/// Convex solids about the x axis of their frame, of a size about 1 m.
namespace tdbd::rock {

/// A solid and its size (m).
struct RoundSolid {
  mesh::ConvexSolid solid_P;
  double size = 0.0;
};

/// A cutter as a bit of one group. Its radius is 0.4 m, its axis is x, and its tip is at +z of the bit's
/// frame. chamfer, wear: m.
bit::Bit cutter_bit(double chamfer, double wear, int rim_segments);

/// Sharp or with a chamfer, new or worn.
bit::Bit any_cutter_bit();

/// The solid of a cutter, or a disc whose axis may be beside x and lean.
RoundSolid any_round_solid();

}  // namespace tdbd::rock
