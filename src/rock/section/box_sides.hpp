#pragma once

#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "mesh/measures.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Buffers of find_around_box, kept between calls to avoid allocations.
struct BoxSidesWork {
  std::vector<int> chains;
  std::vector<int> known;           ///< vertices whose sides are known
  std::vector<std::uint8_t> sides;  ///< per vertex of the rock; 0, as between calls: not known
};

/// Bit mask of the sides of a box beyond which a point lies: bit 2 i for the lower, bit 2 i + 1 for
/// the upper side of axis i.
std::uint8_t sides_beyond(const mesh::Box& box, const Vec3& x);

/// Appends the vertices, of the cells that the region meets, around which a triangle may reach into
/// the box. A vertex is dropped only if it and all its neighbours lie beyond one side of the box,
/// because then all its triangles do, too. Fast if most vertices are dropped. The test uses places
/// in single precision; of_single_places covers their rounding.
void find_around_box(const Rock& rock, const Region& region_W, const mesh::Box& box_P,
                     const Pose& X_PW, BoxSidesWork& work, std::vector<int>& near);

}  // namespace tdbd::rock
