#include "rock/cut/near_planes.hpp"

#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

/// A box as centre and half size.
struct CentredBox {
  Vec3 centre, half;
};

CentredBox centred(const mesh::Box& box) { return {0.5 * (box.lo + box.hi), 0.5 * box.size()}; }

/// Copies the planes that x + t u may meet, with x in a box, u in another and 0 <= t <= t_max:
/// those where n . x - b reaches `least`. `near` needs room for all planes and one more. Returns
/// the number of copied planes.
TDBD_WIDE std::size_t copy_near(const mesh::ConvexSolid& s, const CentredBox& q,
                                const CentredBox& u, double t_max, double least, NearPlanes& n) {
  mesh::ConvexSolid& near = n.solid_P;
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
      n.plane[count] = i + l;
      count += farthest[l] >= least ? 1 : 0;
    }
  }
  return count;
}

void resize(NearPlanes& near, std::size_t n) {
  mesh::ConvexSolid& s = near.solid_P;
  for (auto* column : {&s.nx, &s.ny, &s.nz, &s.b}) column->resize(n);
  near.plane.resize(n);
  s.planes = n;
}

bool is_within(const mesh::Box& box, const mesh::Box& outer) {
  return (box.lo.array() >= outer.lo.array()).all() && (box.hi.array() <= outer.hi.array()).all();
}

mesh::Box widened(const mesh::Box& box, double margin) {
  const Vec3 more = 0.1 * box.size() + Vec3::Constant(margin);
  return {box.lo - more, box.hi + more};
}

}  // namespace

PathBoxes boxes_around(const std::vector<RelativePath>& paths,
                       const std::vector<std::size_t>& which) {
  PathBoxes boxes;
  for (const std::size_t i : which) {
    const RelativePath& p = paths[i];
    boxes.q_P.add(p.q0_P);
    boxes.q_P.add(p.q1_P);
    boxes.u_P.add(p.u0_P);
    boxes.u_P.add(p.u1_P);
  }
  return boxes;
}

double checksum(const mesh::ConvexSolid& s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < s.planes; ++i)
    sum = 0.5 * sum + 3.0 * s.nx[i] + 5.0 * s.ny[i] + 7.0 * s.nz[i] + s.b[i];
  return sum;
}

void find_near_planes(const mesh::ConvexSolid& solid, const PathBoxes& boxes, double depth,
                      double t_max, NearPlanes& near) {
  near.hold_for = boxes;
  near.t_max = t_max;
  near.uses = 0;
  resize(near, solid.b.size() + 1);
  const CentredBox q = centred(boxes.q_P), u = centred(boxes.u_P);
  resize(near, copy_near(solid, q, u, t_max, -2.0 * depth, near));
  mesh::pad(near.solid_P);
}

void update_near_planes(const mesh::ConvexSolid& solid, double sum, const PathBoxes& boxes,
                        double depth, double t_max, NearPlanes& near) {
  constexpr int most_uses = 64;  // limits how long boxes that were wide once are kept
  if (sum == near.checksum && t_max == near.t_max && ++near.uses < most_uses &&
      is_within(boxes.q_P, near.hold_for.q_P) && is_within(boxes.u_P, near.hold_for.u_P))
    return;
  near.checksum = sum;
  find_near_planes(solid, {widened(boxes.q_P, 0.05 * t_max), widened(boxes.u_P, 0.01)}, depth,
                   t_max, near);
}

}  // namespace tdbd::rock
