#include "rock/near_planes.hpp"

#include <array>

#include "rock/wide_planes.hpp"

namespace tdbd::rock {
namespace {

/// A box by its middle and half its size.
struct Middle {
  Vec3 centre, half;
};

Middle middle_of(const mesh::Box& box) { return {0.5 * (box.lo + box.hi), 0.5 * box.size()}; }

/// How far n . x goes beyond b for the x of a box, and n . u for the u of another, lane by lane.
TDBD_WIDE void supports(const mesh::ConvexSolid& s, std::size_t i, const Middle& q, const Middle& u,
                        double t_max, std::array<double, lanes>& beyond) {
  WidePlanes planes;
  load(s, i, planes);
  const auto& [x, y, z, b] = planes;
  const Wide ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y, az = z < 0.0 ? -z : z;
  const Wide at_start = x * q.centre.x() + y * q.centre.y() + z * q.centre.z() + ax * q.half.x() +
                        ay * q.half.y() + az * q.half.z() - b;
  const Wide speed = x * u.centre.x() + y * u.centre.y() + z * u.centre.z() + ax * u.half.x() +
                     ay * u.half.y() + az * u.half.z();
  const Wide farthest = at_start + t_max * (speed > 0.0 ? speed : Wide{});
  TDBD_STORE(farthest, beyond.data());
}

void clear(mesh::ConvexSolid& s) {
  for (auto* column : {&s.nx, &s.ny, &s.nz, &s.b}) column->clear();
  s.planes = 0;
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
  const Middle q_box = middle_of(q), u_box = middle_of(u);
  near.t_max = t_max;
  clear(near.solid_P);
  std::array<double, lanes> beyond;
  for (std::size_t i = 0; i < solid.b.size(); i += lanes) {
    supports(solid, i, q_box, u_box, t_max, beyond);
    for (std::size_t l = 0; l < lanes; ++l)
      if (beyond[l] >= -2.0 * depth)
        mesh::add_plane(near.solid_P, mesh::normal(solid, i + l), solid.b[i + l]);
  }
  mesh::pad(near.solid_P);
}

}  // namespace tdbd::rock
