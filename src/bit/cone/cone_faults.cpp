#include "bit/cone/cone_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "bit/cone/cone_parts.hpp"
#include "bit/cone/tooth_collisions.hpp"
#include "bit/cone/tooth_faults.hpp"
#include "bit/cone/tooth_mesh.hpp"

namespace tdbd::bit {
namespace {

std::string place(const ShellPoint& p) {
  return fmt::format("(s, r) = ({:.4g}, {:.4g}) mm", 1e3 * p.s, 1e3 * p.r);
}

std::vector<ConeFault> shell_faults(const std::vector<ShellPoint>& shell) {
  std::vector<ConeFault> faults;
  if (shell.size() < 2)
    faults.push_back({-1, "shell", fmt::format("{} points", shell.size()), "at least two"});
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == shell.size();
    if (shell[i].r < 0.0 || (shell[i].r == 0.0 && !at_end))
      faults.push_back({-1, "shell", fmt::format("point {} at {}", i + 1, place(shell[i])),
                        "a radius above 0 between the ends"});
    if (i > 0 && shell[i].s <= shell[i - 1].s)
      faults.push_back({-1, "shell",
                        fmt::format("a fold: point {} at {} after {}", i + 1, place(shell[i]),
                                    place(shell[i - 1])),
                        "s rising from the nose to the base"});
  }
  return faults;
}

std::vector<ConeFault> angle_faults(const ToothRow& row) {
  const auto& a = row.angles;
  if (a.empty()) return {{-1, "angles", "no tooth", "at least one"}};
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] < 0.0 || a[i] >= 2.0 * std::numbers::pi || (i > 0 && a[i] <= a[i - 1]))
      return {{-1, "angles", fmt::format("{:.6g} rad for tooth {}", a[i], i + 1),
               "angles that rise within one turn"}};
  return {};
}

/// Place of a point of a tooth on the cone's meridian.
ShellPoint meridian_place(const ConeLayout& cone, const ToothRow& row, const Vec3& x_T) {
  const Vec3 x_K = tooth_pose(cone, row, 0.0) * x_T;
  return {-x_K.z(), std::hypot(x_K.x(), x_K.y())};
}

std::vector<ConeFault> seat_faults(const ConeLayout& cone, const ToothRow& row) {
  const Meridian shell = shell_meridian(cone.shell);
  std::vector<ConeFault> faults;
  const ShellPoint tip = meridian_place(cone, row, {0.0, 0.0, row.shape.protrusion});
  if (const double out = signed_distance(shell, tip); out <= 0.0)
    faults.push_back({-1, "protrusion",
                      fmt::format("a tip at {}, {:.4g} mm inside the cone", place(tip), -1e3 * out),
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

}  // namespace tdbd::bit
