#include "bit/cone/swept_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bit/cone/cone_parts.hpp"
#include "core/types.hpp"

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

/// Values that are equal for all teeth of a row of a cone: means and limits of s and r, m.
using RowSignature = std::array<double, 5>;

RowSignature signature_of(const Cone& cone, const Part& tooth) {
  const Pose X_KP = inverse(cone.X_BK) * tooth.X_BP;
  const auto count = static_cast<double>(tooth.mesh_P.positions.size());
  RowSignature row{0.0, 0.0, 1e300, -1e300, 0.0};
  for (const Vec3& x_P : tooth.mesh_P.positions) {
    const Vec3 x_K = X_KP * x_P;
    const double s = -x_K.z(), r = x_K.head<2>().norm();
    row[0] += s / count;
    row[1] += r / count;
    row[2] = std::min(row[2], s);
    row[3] = std::max(row[3], s);
    row[4] = std::max(row[4], r);
  }
  return row;
}

bool is_same_row(const RowSignature& a, const RowSignature& b, double apart) {
  return std::ranges::equal(a, b, [&](double x, double y) { return std::abs(x - y) < apart; });
}

/// The surfaces swept by the teeth of a cone without a layout, one part per row. For teeth that are
/// not convex, a convex part around the swept volume is used.
void add_swept_meshes(const Bit& bit, int cone_index, int segments, std::vector<Part>& parts) {
  constexpr double rounding = 1e-6;  // m, of files in single precision
  const Cone& cone = bit.cones[static_cast<std::size_t>(cone_index)];
  int row = 0;
  for (const int tooth : one_tooth_of_each_row(bit, cone_index, rounding)) {
    const Part& part = bit.parts[static_cast<std::size_t>(tooth)];
    Part swept;
    swept.name = fmt::format("{}/row-{}", cone.name, ++row);
    swept.kind = PartKind::tooth;
    swept.X_BP = cone.X_BK;
    const Meridian meridian = swept_meridian(part.mesh_P, inverse(cone.X_BK) * part.X_BP);
    swept.mesh_P = turned_about_journal(meridian, segments);
    parts.push_back(std::move(swept));
  }
}

}  // namespace

std::vector<int> one_tooth_of_each_row(const Bit& bit, int cone, double apart) {
  std::vector<RowSignature> rows;
  std::vector<int> teeth;
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const Part& part = bit.parts[i];
    if (part.cone != cone || part.row >= 0 || !stands_in_a_row(part)) continue;
    const RowSignature row = signature_of(bit.cones[static_cast<std::size_t>(cone)], part);
    if (std::ranges::any_of(rows,
                            [&](const RowSignature& r) { return is_same_row(r, row, apart); }))
      continue;
    rows.push_back(row);
    teeth.push_back(static_cast<int>(i));
  }
  return teeth;
}

std::vector<Part> swept_parts(const Bit& bit, int segments) {
  std::vector<Part> parts;
  for (const Part& part : bit.parts)
    if (part.cutting == Cutting::cuts && !stands_in_a_row(part)) parts.push_back(part);
  for (const Cone& cone : bit.cones)
    for (std::size_t row = 0; row < cone.layout.rows.size(); ++row)
      parts.push_back(swept_row(cone, row, segments));
  for (std::size_t cone = 0; cone < bit.cones.size(); ++cone)
    add_swept_meshes(bit, static_cast<int>(cone), segments, parts);
  return parts;
}

}  // namespace tdbd::bit
