#include "reference/mesh/exact_volume.hpp"

#include "reference/mesh/exact_rational.hpp"

namespace tdbd::reference {

double enclosed_volume_exact(const mesh::TriangleMesh& closed) {
  return CGAL::to_double(signed_volume_rational(closed));
}

double signed_volume_exact(const mesh::TriangleMesh& open) {
  return CGAL::to_double(signed_volume_rational(open));
}

double removed_volume_exact(const mesh::TriangleMesh& before, const mesh::TriangleMesh& after) {
  return CGAL::to_double(-prism_volume_rational(before, after));
}

}  // namespace tdbd::reference
