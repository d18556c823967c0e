#include "bit/cone/cone_shell.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cone/meridian.hpp"
#include "bit/surface_of_revolution.hpp"

namespace tdbd::bit {
namespace {

/// The outward normal of the piece of the profile from a to b.
ShellPoint piece_normal(const ShellPoint& a, const ShellPoint& b) {
  const double length = std::hypot(b.s - a.s, b.r - a.r);
  return {-(b.r - a.r) / length, (b.s - a.s) / length};
}

ShellPoint halfway(const ShellPoint& a, const ShellPoint& b) {
  const double length = std::hypot(a.s + b.s, a.r + b.r);
  return {(a.s + b.s) / length, (a.r + b.r) / length};
}

mesh::TriangleMesh turned(const Meridian& meridian, int segments) {
  std::vector<Ring> rings;
  rings.reserve(meridian.size());
  for (const ShellPoint& p : meridian) rings.push_back({p.r, -p.s, p.r > 0.0 ? segments : 1});
  mesh::TriangleMesh m = surface_of_revolution(rings);
  for (Vec3& x : m.positions) x = Vec3(x.y(), x.z(), x.x());  // rings are about X
  return m;
}

}  // namespace

ShellPlace shell_place(const std::vector<ShellPoint>& shell, double s) {
  if (s == shell.front().s && shell.front().r == 0.0) return {shell.front(), {-1.0, 0.0}};
  std::size_t i = 1;
  while (i + 1 < shell.size() && shell[i].s < s) ++i;
  const ShellPoint &a = shell[i - 1], &b = shell[i];
  const double t = (s - a.s) / (b.s - a.s);
  ShellPlace place{{s, a.r + t * (b.r - a.r)}, piece_normal(a, b)};
  if (s == b.s && i + 1 < shell.size())
    place.normal = halfway(place.normal, piece_normal(b, shell[i + 1]));
  return place;
}

mesh::TriangleMesh shell_mesh(const ConeLayout& cone) {
  return turned(shell_meridian(cone.shell), cone.segments);
}

std::vector<mesh::TriangleMesh> shell_pieces(const ConeLayout& cone) {
  std::vector<mesh::TriangleMesh> pieces;
  pieces.reserve(cone.shell.size());
  for (std::size_t i = 1; i < cone.shell.size(); ++i)
    pieces.push_back(turned(shell_meridian({cone.shell[i - 1], cone.shell[i]}), cone.segments));
  return pieces;
}

}  // namespace tdbd::bit
