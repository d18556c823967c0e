#pragma once

#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "mesh/measures.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Buffers of find_around_box, kept between calls so that none allocates once warm.
struct BoxSidesWork {
  std::vector<int> chains;
  std::vector<int> known;           ///< vertices whose sides are known
  std::vector<std::uint8_t> sides;  ///< per vertex of the rock; 0 between calls: not known
};

/// Beyond which sides of a box a point lies: bit 2 i for the lower, bit 2 i + 1 for the upper side of
/// axis i.
std::uint8_t sides_beyond(const mesh::Box& box, const Vec3& x);

/// Appends those vertices of the cells that the region meets around which a triangle may reach into the
/// box. Drops a vertex only if it and all its neighbours lie beyond one side of the box: then so do all
/// its triangles. So all vertices of the cells that belong to another triangle are kept. Cheap for many
/// vertices around few that are kept; places in single precision decide, whose rounding
/// of_single_places covers.
void find_around_box(const Rock& rock, const Region& region_W, const mesh::Box& box_P,
                     const Pose& X_PW, BoxSidesWork& work, std::vector<int>& near);

}  // namespace tdbd::rock
