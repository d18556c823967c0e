#pragma once

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

struct PlaneSection {
  double area = 0.0;             ///< m2
  Vec3 centroid = Vec3::Zero();  ///< m, in W
};

/// Computes the section of a convex closed mesh at the pose X_WP with the plane z = 0 of W: the
/// points where its edges cross the plane, sorted by their direction from their mean. Twin of
/// rock::rubbing_contact on flat rock.
PlaneSection plane_section(const mesh::TriangleMesh& convex_P, const Pose& X_WP);

}  // namespace tdbd::reference
