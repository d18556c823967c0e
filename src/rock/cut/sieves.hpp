#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/simd.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// Maps places relative to a list's origin into a frame, in single precision.
struct SingleFrame {
  std::array<Single, 9> R{};  ///< row-major
  std::array<Single, 3> p{};
};

SingleFrame single_frame(const Pose& X_PW, const Vec3& origin_W);

/// Eight places in the frame, m. Only for functions that are TDBD_WIDE.
TDBD_INLINE void put_in_frame(const WidePoints& x, const SingleFrame& X_PW, WidePoints& q_P) {
  const auto& R = X_PW.R;
  q_P = {R[0] * x.x + R[1] * x.y + R[2] * x.z + X_PW.p[0],
         R[3] * x.x + R[4] * x.y + R[5] * x.z + X_PW.p[1],
         R[6] * x.x + R[7] * x.y + R[8] * x.z + X_PW.p[2]};
}

/// A widened box in single precision.
struct SingleBox {
  std::array<Single, 3> lo{}, hi{};
};

SingleBox single_box(const mesh::Box& box, double slack);

/// Selects the vertices that a group may sweep between its two poses, and those that it may touch
/// at the end (none if touched_slack is negative). Swept: no side of the box and no plane of the
/// hull has the vertex outside by swept_slack at both poses. Touched: none has it outside by
/// touched_slack at the end.
struct Sieve {
  SingleFrame start, end;
  SingleBox touched, either;  ///< widened by touched_slack; by the larger slack
  Single swept_slack, touched_slack;
  const SingleSolid& hull_P;
};

/// Makes the sieve for a list that covers the group's motion. swept_slack is twice the rounding
/// bound. Therefore keeps_outside rejects everything that the sieve rejects, and the result does
/// not depend on the list. `gap`: m, for touched vertices.
Sieve make_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap);

/// Places in the group's frame at the two poses of a sieve, as columns, in whole packs of eight.
struct PlaceBatch {
  static constexpr std::size_t most = 256;
  std::array<std::array<Single, most>, 3> start, end;  ///< by x, y, z
  std::array<int, most> place;                         ///< index in the list
  std::size_t count = 0;
};

/// Bit l: whether ball l of eight may reach into the group's box and inside all planes of its hull
/// at either pose.
unsigned balls_near(const Balls& balls, std::size_t i, const Sieve& s);

/// Appends eight places of the list, from i on, behind the run's end. Bit l: whether place l is in
/// the box at either pose.
unsigned put_into_frames(const NearList& list, std::size_t i, const Sieve& s, PlaceBatch& run);

/// Bit masks of the places that pass.
struct SievePass {
  unsigned swept, touched;
};

/// Tests eight places of the run, from i on, against the first `planes` planes.
void sieve_pack(const PlaceBatch& r, std::size_t i, const Sieve& s, std::size_t planes,
                SievePass& sieved);

/// A cylinder about the x axis of P in single precision.
struct SingleCylinder {
  Single x_lo, x_hi, radius;
  Single radius2;  ///< negative if the radius is negative: the cylinder is empty
};

/// Selects the vertices that a round group may sweep between its two poses, and those that it may
/// touch at the end. A vertex moves straight from q0 to q1 in the group's frame. The group sweeps
/// no vertex that stays outside one end of its cylinder or never comes within its radius of the
/// axis.
struct RoundSieve {
  SingleFrame start, end;
  SingleCylinder near;          ///< at the end; contains all places of the other cylinders
  SingleCylinder swept, inner;  ///< widened and narrowed by twice the rounding bound
  SingleBox inner_end;          ///< the motion's region in P at the end, narrowed as well
  SingleCylinder touched;       ///< at the end; empty if the gap is negative
};

/// Makes the sieve for a list that covers the group's motion. The group must be round. `gap`: m,
/// for touched vertices.
RoundSieve make_round_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list,
                            double gap);

/// Eight places of a list, from `begin` on. Bit masks: places that may be swept, places that pass
/// keeps_outside for certain in spite of rounding, and places that may be touched.
struct SievedPack {
  int begin;
  unsigned swept, certain, touched;
};

/// Writes the packs in which any place passes to the front of `packs`, in the order of the list.
/// Returns their number.
std::size_t sieve_round(const NearList& list, const RoundSieve& s, std::vector<SievedPack>& packs);

/// Whether the segment from q0 to q1 stays outside one end of a round group's cylinder, or never
/// comes within its radius plus `slack` (m) of the axis.
bool misses_cylinder(const CuttingGroup& g, const Vec3& q0_P, const Vec3& q1_P, double slack);

}  // namespace tdbd::rock
