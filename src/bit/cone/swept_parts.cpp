#include "bit/cone/swept_parts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bit/cone/cone_parts.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

mesh::TriangleMesh turned_about_journal(const Meridian& m, int segments) {
  mesh::TriangleMesh ring;
  const int sides = static_cast<int>(m.size());
  for (int k = 0; k < segments; ++k) {
    const double angle = full_turn * k / segments;
    for (const ShellPoint& p : m)
      ring.positions.emplace_back(p.r * std::cos(angle), p.r * std::sin(angle), -p.s);
  }
  const auto at = [&](int k, int i) { return (k % segments) * sides + i % sides; };
  for (int k = 0; k < segments; ++k)
    for (int i = 0; i < sides; ++i) {
      ring.triangles.push_back({at(k, i), at(k + 1, i), at(k + 1, i + 1)});
      ring.triangles.push_back({at(k, i), at(k + 1, i + 1), at(k, i + 1)});
    }
  return ring;
}

Part swept_row(const Cone& cone, std::size_t row, int segments) {
  Part swept;
  swept.name = fmt::format("{}/row-{}", cone.name, row + 1);
  swept.kind = PartKind::tooth;
  swept.X_BP = cone.X_BK;
  swept.mesh_P = turned_about_journal(row_meridian(cone.layout, cone.layout.rows[row]), segments);
  return swept;
}

bool stands_in_a_row(const Part& part) { return part.cone >= 0 && part.kind == PartKind::tooth; }

}  // namespace

std::vector<Part> swept_parts(const Bit& bit, int segments) {
  std::vector<Part> parts;
  for (const Part& part : bit.parts)
    if (part.cutting == Cutting::cuts && !stands_in_a_row(part)) parts.push_back(part);
  for (const Cone& cone : bit.cones)
    for (std::size_t row = 0; row < cone.layout.rows.size(); ++row)
      parts.push_back(swept_row(cone, row, segments));
  return parts;
}

}  // namespace tdbd::bit
