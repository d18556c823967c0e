#include "rock/cut/near_planes.hpp"

#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

/// A box by its centre and half its size.
struct CentredBox {
  Vec3 centre, half;
};

CentredBox centred(const mesh::Box& box) { return {0.5 * (box.lo + box.hi), 0.5 * box.size()}; }

/// Copies the planes that x + t u may meet, with x in a box, u in another and 0 <= t <= t_max:
/// those where n . x - b reaches `least`. `near` must have room for all and one more. Returns how
/// many.
TDBD_WIDE std::size_t copy_near(const mesh::ConvexSolid& s, const CentredBox& q,
                                const CentredBox& u, double t_max, double least,
                                mesh::ConvexSolid& near) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y, az = z < 0.0 ? -z : z;
    const Wide at_start = x * q.centre.x() + y * q.centre.y() + z * q.centre.z() + ax * q.half.x() +
                          ay * q.half.y() + az * q.half.z() - b;
    const Wide speed = x * u.centre.x() + y * u.centre.y() + z * u.centre.z() + ax * u.half.x() +
                       ay * u.half.y() + az * u.half.z();
    const Wide farthest = at_start + t_max * (speed > 0.0 ? speed : Wide{});
    for (std::size_t l = 0; l < lanes; ++l) {
      near.nx[count] = x[l], near.ny[count] = y[l], near.nz[count] = z[l], near.b[count] = b[l];
      count += farthest[l] >= least ? 1 : 0;
    }
  }
  return count;
}

void resize(mesh::ConvexSolid& s, std::size_t n) {
  for (auto* column : {&s.nx, &s.ny, &s.nz, &s.b}) column->resize(n);
  s.planes = n;
}

}  // namespace

void find_near_planes(const mesh::ConvexSolid& solid, const std::vector<RelativePath>& paths,
                      double depth, double t_max, NearPlanes& near) {
  mesh::Box q, u;
  for (const RelativePath& p : paths) {
    q.add(p.q0_P);
    q.add(p.q1_P);
    u.add(p.u0_P);
    u.add(p.u1_P);
  }
  const CentredBox q_box = centred(q), u_box = centred(u);
  near.t_max = t_max;
  resize(near.solid_P, solid.b.size() + 1);
  resize(near.solid_P, copy_near(solid, q_box, u_box, t_max, -2.0 * depth, near.solid_P));
  mesh::pad(near.solid_P);
}

}  // namespace tdbd::rock
