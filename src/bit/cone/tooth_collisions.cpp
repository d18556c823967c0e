#include "bit/cone/tooth_collisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "bit/cone/cone_parts.hpp"
#include "bit/cone/tooth_mesh.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

/// A row's teeth in K: corners and planes of each.
struct RowSolids {
  std::vector<std::vector<Vec3>> corners_K;
  std::vector<mesh::ConvexSolid> solids_K;
  double reach = 0.0;  ///< m, of a tooth from its frame's origin
};

mesh::TriangleMesh moved(mesh::TriangleMesh m, const Pose& X) {
  for (Vec3& x : m.positions) x = X * x;
  return m;
}

RowSolids solids_of(const ConeLayout& cone, const ToothRow& row) {
  RowSolids all;
  const mesh::TriangleMesh mesh_T = tooth_mesh(row.shape, cone.facets);
  for (const Vec3& x : mesh_T.positions) all.reach = std::max(all.reach, x.norm());
  for (const double angle : row.angles) {
    const mesh::TriangleMesh mesh_K = moved(mesh_T, tooth_pose(cone, row, angle));
    all.corners_K.push_back(mesh_K.positions);
    all.solids_K.push_back(mesh::convex_solid(mesh_K).value_or(mesh::ConvexSolid{}));
  }
  return all;
}

bool separates(const mesh::ConvexSolid& a, const std::vector<Vec3>& b) {
  for (std::size_t i = 0; i < a.planes; ++i)
    if (std::ranges::all_of(b, [&](const Vec3& x) { return mesh::normal(a, i).dot(x) >= a.b[i]; }))
      return true;
  return false;
}

struct Pair {
  std::size_t first, second;
};

std::optional<Pair> first_collision(const RowSolids& a, const RowSolids& b, bool same_row) {
  for (std::size_t i = 0; i < a.corners_K.size(); ++i)
    for (std::size_t k = same_row ? i + 1 : 0; k < b.corners_K.size(); ++k)
      if ((a.corners_K[i].front() - b.corners_K[k].front()).norm() < 2.0 * (a.reach + b.reach) &&
          !separates(a.solids_K[i], b.corners_K[k]) && !separates(b.solids_K[k], a.corners_K[i]))
        return Pair{i, k};
  return std::nullopt;
}

}  // namespace

std::vector<ConeFault> tooth_collisions(const ConeLayout& cone) {
  constexpr double degree = std::numbers::pi / 180.0;
  std::vector<RowSolids> rows;
  for (const ToothRow& row : cone.rows) rows.push_back(solids_of(cone, row));
  std::vector<ConeFault> faults;
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t i = 0; i <= j; ++i)
      if (const auto pair = first_collision(rows[i], rows[j], i == j))
        faults.push_back(
            {static_cast<int>(j), "s",
             fmt::format("tooth {} at {:.4g} deg in tooth {} of row {}", pair->second + 1,
                         cone.rows[j].angles[pair->second] / degree, pair->first + 1, i + 1),
             "teeth that do not touch"});
  return faults;
}

}  // namespace tdbd::bit
