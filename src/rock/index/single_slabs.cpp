#include "rock/index/single_slabs.hpp"

namespace tdbd::rock {

SingleSlabs about(const Vec3& origin_W, const std::array<Slab, 3>& slabs, double slack) {
  SingleSlabs single;
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    const Slab& s = slabs[k];
    single.nx[k] = static_cast<Single>(s.n.x());
    single.ny[k] = static_cast<Single>(s.n.y());
    single.nz[k] = static_cast<Single>(s.n.z());
    single.lo[k] = static_cast<Single>(s.lo - slack - s.n.dot(origin_W));
    single.hi[k] = static_cast<Single>(s.hi + slack - s.n.dot(origin_W));
  }
  return single;
}

}  // namespace tdbd::rock
