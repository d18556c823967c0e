#pragma once

#include <array>

#include "core/wide.hpp"
#include "rock/cut/group_motion.hpp"
#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// From places about a list's origin to a frame, in single precision.
struct SingleFrame {
  std::array<Single, 9> R{};  ///< by rows
  std::array<Single, 3> p{};
};

/// A box in single precision, widened.
struct SingleBox {
  std::array<Single, 3> lo{}, hi{};
};

/// What tells what a group may sweep on its way from one pose to the other, and what it may touch
/// at the end; nothing if that slack is negative. Swept: no side of the box and no plane of the
/// hull has the vertex outside by its slack at both poses. Touched: none has it outside by the
/// other slack at the end.
struct Sieve {
  SingleFrame start, end;
  SingleBox touched, either;  ///< widened by its slack; by either
  Single swept_slack, touched_slack;
  const SingleSolid& hull_P;
};

/// Of a group's motion, for a list that covers it. Swept has twice the slack of rounding: what this
/// turns away, keeps_outside would, so that the list has no say. `gap`: m, of what is touched.
Sieve make_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap);

/// Places in the group's frame at the two poses of a sieve, side by side, for whole packs.
struct Run {
  static constexpr std::size_t most = 256;
  std::array<Single, most> x0, y0, z0, x1, y1, z1;
  std::array<int, most> place;  ///< in the list
  std::size_t count = 0;
};

/// Bit l: whether the ball l of eight may hold something that is inside of the group's box and of
/// the first planes of its hull at either pose.
unsigned balls_near(const Balls& balls, std::size_t i, const Sieve& s);

/// Puts the places of the list from i on into the run's room for a pack. Bit l: whether the place l
/// of eight is in the box at either pose.
unsigned put_into_frames(const NearList& list, std::size_t i, const Sieve& s, Run& run);

/// Bits: those of eight places that are left.
struct Sieved {
  unsigned swept, touched;
};

/// Eight places of the run, from i on, by so many of the planes.
void sieve_pack(const Run& r, std::size_t i, const Sieve& s, std::size_t planes, Sieved& sieved);

}  // namespace tdbd::rock
