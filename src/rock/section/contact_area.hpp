#pragma once

#include <vector>

#include "core/parallel.hpp"
#include "rock/cut/cut_rock.hpp"

namespace tdbd::rock {

/// Buffers of one thread.
struct ContactRoom {
  std::vector<int> chains, around;
  std::vector<int> near;     ///< vertices that a part of the group at work may touch
  std::vector<Vec3> near_P;  ///< m, the same at the end of the step
  std::vector<int> held;
  std::vector<int> mark;  ///< per vertex
  int stamp = 0;
};

/// Buffers for the contact areas of a step, kept between steps so that none allocates once warm.
struct ContactWork {
  PerThread<ContactRoom> rooms;
};

/// The rock surface in contact with one part of the bit. All zero: none.
struct PartContact {
  double area = 0.0;                  ///< m2, sum of the triangles' areas
  Vec3 area_vector_W = Vec3::Zero();  ///< m2, sum of area times normal, out of the rock
  Vec3 centroid_W = Vec3::Zero();     ///< m, of the triangles, weighted by area
};

/// The contact area of every part of the bit, rock (14) (reconstructed): the rock triangles whose
/// three vertices the part moved in this step or touches at its end, that is, has within `gap` (m)
/// of its surface. A triangle may count for several parts. Call it after cut_rock and before
/// maintenance; `cut` is the workspace of that step. Cost is proportional to the vertices near the
/// bit.
void contact_areas(const Rock& rock, const CuttingBit& bit, const CutWorkspace& cut, double gap,
                   ContactWork& work, std::vector<PartContact>& contact_by_part);

}  // namespace tdbd::rock
