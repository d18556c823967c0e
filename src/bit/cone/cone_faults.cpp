#include "bit/cone/cone_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bit/bit.hpp"
#include "bit/cone/cone_parts.hpp"
#include "core/types.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

void demand_positive(const ToothShape& t, std::vector<ConeFault>& faults) {
  const auto demand = [&](const char* key, double value) {
    if (!(value > 0.0)) faults.push_back({-1, key, mm_text(value), "a length above 0"});
  };
  demand("diameter", t.diameter);
  demand("protrusion", t.protrusion);
  demand("embedding", t.embedding);
  if (t.kind == ToothKind::conical) demand("tip_radius", t.tip_radius);
  if (t.kind == ToothKind::milled_chisel) demand("width", t.width);
  if (t.kind == ToothKind::milled_chisel || t.kind == ToothKind::chisel) {
    demand("crest_length", t.crest_length);
    demand("crest_width", t.crest_width);
  }
}

void demand_at_most(const char* key, double value, double most, std::vector<ConeFault>& faults) {
  if (value > most) faults.push_back({-1, key, mm_text(value), "at most " + mm_text(most)});
}

void check_crest(const ToothShape& t, std::vector<ConeFault>& faults) {
  const double across = t.kind == ToothKind::milled_chisel ? t.width : t.crest_length;
  demand_at_most("crest_length", t.crest_length, t.diameter, faults);
  demand_at_most("crest_width", t.crest_width, across, faults);
}

/// The conical flank begins above the shank's rim. It must not begin below the insert's lower end.
void check_cone(const ToothShape& t, std::vector<ConeFault>& faults) {
  const double at_tangent = t.tip_radius * std::cos(t.half_angle);
  demand_at_most("tip_radius", at_tangent, 0.5 * t.diameter, faults);
  const double flank = t.tip_radius * (1.0 - std::sin(t.half_angle)) +
                       (0.5 * t.diameter - at_tangent) / std::tan(t.half_angle);
  if (flank >= t.protrusion + t.embedding)
    faults.push_back({-1, "half_angle",
                      fmt::format("{:.4g} rad, a flank {} high", t.half_angle, mm_text(flank)),
                      "a flank lower than protrusion and embedding together, " +
                          mm_text(t.protrusion + t.embedding)});
}

std::string shell_text(const ShellPoint& p) {
  return fmt::format("(s, r) = ({:.4g}, {:.4g}) mm", 1e3 * p.s, 1e3 * p.r);
}

std::vector<ConeFault> shell_faults(const std::vector<ShellPoint>& shell) {
  std::vector<ConeFault> faults;
  if (shell.size() < 2)
    faults.push_back({-1, "shell", fmt::format("{} points", shell.size()), "at least two"});
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == shell.size();
    if (shell[i].r < 0.0 || (shell[i].r == 0.0 && !at_end))
      faults.push_back({-1, "shell", fmt::format("point {} at {}", i + 1, shell_text(shell[i])),
                        "a radius above 0 between the ends"});
    if (i > 0 && shell[i].s <= shell[i - 1].s)
      faults.push_back({-1, "shell",
                        fmt::format("a fold: point {} at {} after {}", i + 1, shell_text(shell[i]),
                                    shell_text(shell[i - 1])),
                        "s rising from the nose to the base"});
  }
  return faults;
}

std::vector<ConeFault> angle_faults(const ToothRow& row) {
  const auto& a = row.angles;
  if (a.empty()) return {{-1, "angles", "no tooth", "at least one"}};
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] < 0.0 || a[i] >= full_turn || (i > 0 && a[i] <= a[i - 1]))
      return {{-1, "angles", fmt::format("{:.6g} rad for tooth {}", a[i], i + 1),
               "angles that rise within one turn"}};
  return {};
}

/// The place of a point of a tooth on the cone's meridian.
ShellPoint meridian_place(const ConeLayout& cone, const ToothRow& row, const Vec3& x_T) {
  const Vec3 x_K = tooth_pose(cone, row, 0.0) * x_T;
  return {-x_K.z(), std::hypot(x_K.x(), x_K.y())};
}

std::vector<ConeFault> seat_faults(const ConeLayout& cone, const ToothRow& row) {
  const Meridian shell = shell_meridian(cone.shell);
  std::vector<ConeFault> faults;
  const ShellPoint tip = meridian_place(cone, row, {0.0, 0.0, row.shape.protrusion});
  if (const double out = signed_distance(shell, tip); out <= 0.0)
    faults.push_back(
        {-1, "protrusion",
         fmt::format("a tip at {}, {:.4g} mm inside the cone", shell_text(tip), -1e3 * out),
         "a tip outside of the shell"});
  double off = 0.0;
  for (const Vec3& x_T : tooth_mesh(row.shape, cone.facets).positions)
    if (x_T.z() == -row.shape.embedding)
      off = std::max(off, signed_distance(shell, meridian_place(cone, row, x_T)));
  if (off > 0.0)
    faults.push_back({-1, "embedding",
                      fmt::format("a base that stands {:.4g} mm off the cone", 1e3 * off),
                      "a base inside the shell"});
  return faults;
}

std::vector<ConeFault> row_faults(const ConeLayout& cone, const ToothRow& row) {
  if (row.s < cone.shell.front().s || row.s > cone.shell.back().s)
    return {{-1, "s", fmt::format("{:.4g} mm", 1e3 * row.s),
             fmt::format("a place on the shell, from {:.4g} to {:.4g} mm",
                         1e3 * cone.shell.front().s, 1e3 * cone.shell.back().s)}};
  std::vector<ConeFault> faults = angle_faults(row);
  if (faults.empty()) faults = tooth_faults(row.shape);
  if (faults.empty()) faults = seat_faults(cone, row);
  return faults;
}

/// The teeth of a row in K: corners and planes of each.
struct RowSolids {
  std::vector<std::vector<Vec3>> corners_K;
  std::vector<mesh::ConvexSolid> solids_K;
  double reach = 0.0;  ///< m, largest distance of a tooth's point from the origin of its frame
};

mesh::ConvexSolid moved(const mesh::ConvexSolid& solid_T, const Pose& X_KT) {
  mesh::ConvexSolid solid_K;
  for (std::size_t i = 0; i < solid_T.planes; ++i) {
    const Vec3 n_K = X_KT.R * mesh::normal(solid_T, i);
    mesh::add_plane(solid_K, n_K, solid_T.b[i] + n_K.dot(X_KT.p));
  }
  return solid_K;
}

/// Teeth are convex, whatever their number of facets.
RowSolids solids_of(const ConeLayout& cone, const ToothRow& row) {
  RowSolids all;
  const mesh::TriangleMesh mesh_T = tooth_mesh(row.shape, cone.facets);
  const mesh::ConvexSolid solid_T =
      mesh::convex_solid(mesh_T, mesh_T.triangles.size()).value_or(mesh::ConvexSolid{});
  for (const Vec3& x : mesh_T.positions) all.reach = std::max(all.reach, x.norm());
  for (const double angle : row.angles) {
    const Pose X_KT = tooth_pose(cone, row, angle);
    std::vector<Vec3>& corners_K = all.corners_K.emplace_back(mesh_T.positions);
    for (Vec3& x : corners_K) x = X_KT * x;
    all.solids_K.push_back(moved(solid_T, X_KT));
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

/// Finds teeth that no plane of either separates: the first pair of every two rows (or within one
/// row). Requires rows without faults of their own.
std::vector<ConeFault> tooth_collisions(const ConeLayout& cone) {
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

}  // namespace

std::vector<ConeFault> cone_faults(const ConeLayout& cone) {
  std::vector<ConeFault> faults = shell_faults(cone.shell);
  if (!faults.empty()) return faults;
  for (int i = 0; i < static_cast<int>(cone.rows.size()); ++i)
    for (ConeFault& fault : row_faults(cone, cone.rows[static_cast<std::size_t>(i)])) {
      fault.row = i;
      faults.push_back(std::move(fault));
    }
  return faults.empty() ? tooth_collisions(cone) : faults;
}

std::vector<ConeFault> tooth_faults(const ToothShape& t) {
  std::vector<ConeFault> faults;
  demand_positive(t, faults);
  if (!faults.empty()) return faults;
  if (t.kind == ToothKind::chisel || t.kind == ToothKind::milled_chisel) check_crest(t, faults);
  if (t.kind == ToothKind::conical) check_cone(t, faults);
  if (t.kind == ToothKind::hemispherical && t.protrusion + t.embedding <= 0.5 * t.diameter)
    faults.push_back({-1, "embedding", mm_text(t.embedding),
                      "more than the half-ball reaches below the shell, " +
                          mm_text(0.5 * t.diameter - t.protrusion)});
  return faults;
}

}  // namespace tdbd::bit
