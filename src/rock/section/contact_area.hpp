#pragma once

#include <vector>

#include "rock/cut/cut_rock.hpp"

namespace tdbd::rock {

/// Room for the contact areas of a step, kept between steps so that none allocates once warm.
struct ContactWork {
  std::vector<int> chains;
  std::vector<int> near;     ///< vertices that a part of the group at work may touch
  std::vector<Vec3> near_P;  ///< m, the same at the end of the step
  std::vector<int> held, triangles;
  std::vector<int> mark;  ///< per vertex
  int stamp = 0;
};

/// The rock surface that one part of the bit holds. All zero: none.
struct PartContact {
  double area = 0.0;                  ///< m2, sum of the triangles' areas
  Vec3 area_vector_W = Vec3::Zero();  ///< m2, sum of area times normal, out of the rock
  Vec3 centroid_W = Vec3::Zero();     ///< m, of the triangles, weighted by area
};

/// What every part of the bit holds of the rock, formulation 2.6 [R]: those rock triangles
/// whose three vertices the part moved in this step or touches at its end, i.e. has within `gap`
/// (m) of its surface. A triangle may count for several parts. To be asked after cut_rock and
/// before maintenance; `cut` is the room of that step. Cost follows the vertices near the bit.
void contact_areas(const Rock& rock, const CuttingBit& bit, const CutWorkspace& cut, double gap,
                   ContactWork& work, std::vector<PartContact>& contact_by_part);

}  // namespace tdbd::rock
