#include "reference/literature/surface/z_map_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tdbd::reference {
namespace {

/// Corners sorted by y, so that two facets treat their common edge identically.
using Facet = std::array<Vec3, 3>;

/// The interval of a facet along a line y: x and z at both ends. Depths in between never leave the
/// facet's own range, however steep it is.
struct RowSpan {
  double x_lo, x_hi, z_lo, z_hi;
};

Facet facet(Vec3 a, Vec3 b, Vec3 c) {
  if (a.y() > b.y()) std::swap(a, b);
  if (b.y() > c.y()) std::swap(b, c);
  if (a.y() > b.y()) std::swap(a, b);
  return {a, b, c};
}

/// The edge from `a` up to `b` at the line y; b.y() > a.y(). Clamped, because rows are found by
/// rounding, and at an almost horizontal edge a rounding error is a long distance.
Vec3 at(const Vec3& a, const Vec3& b, double y) {
  return a + std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0) * (b - a);
}

/// The facet along the line y, which passes between its lowest and highest corner.
RowSpan extent(const Facet& f, double y) {
  const auto& [a, b, c] = f;
  const bool below_middle = y < b.y() || b.y() == c.y();
  const Vec3 far = at(a, c, y), near = below_middle ? at(a, b, y) : at(b, c, y);
  if (far.x() < near.x()) return {far.x(), near.x(), far.z(), near.z()};
  return {near.x(), far.x(), near.z(), far.z()};
}

/// Grid coordinates: the first cell whose centre is at or after x, and the last one at or before
/// it.
struct Grid {
  double half, cell, per_cell;
  int cells;

  double centre(int i) const { return (i + 0.5) * cell - half; }
  int first(double x) const {
    return std::max(static_cast<int>(std::ceil((x + half) * per_cell - 0.5)), 0);
  }
  int last(double x) const {
    return std::min(static_cast<int>(std::floor((x + half) * per_cell - 0.5)), cells - 1);
  }
};

/// Lowers cells of one row. Returns the sum of the changes.
double cut_row(double* height, int count, double depth, double step) {
  double change = 0.0;
  for (int k = 0; k < count; ++k) {
    const double deeper = std::max(0.0, depth + k * step - height[k]);
    change += deeper;
    height[k] += deeper;
  }
  return change;
}

double cut_facet(const Grid& grid, std::vector<double>& height, const Facet& f) {
  const double low = f.front().y(), high = f.back().y();
  if (low == high) return 0.0;
  double change = 0.0;
  const int last_row = grid.last(high);
  for (int row = grid.first(low); row <= last_row; ++row) {
    const RowSpan s = extent(f, grid.centre(row));
    const int first = grid.first(s.x_lo), count = grid.last(s.x_hi) - first + 1;
    if (count <= 0) continue;
    const double slope = s.x_hi > s.x_lo ? (s.z_hi - s.z_lo) / (s.x_hi - s.x_lo) : 0.0;
    change += cut_row(height.data() + static_cast<std::ptrdiff_t>(row) * grid.cells + first, count,
                      s.z_lo + slope * (grid.centre(first) - s.x_lo), slope * grid.cell);
  }
  return change;
}

}  // namespace

double cut_sweep(ZMap& rock, const mesh::TriangleMesh& lower_B, const Pose& X_WB) {
  const double cell = rock.cell();
  const Grid grid{rock.half, cell, 1.0 / cell, rock.cells};
  double change = 0.0;
  for (const auto& [a, b, c] : lower_B.triangles)
    change += cut_facet(grid, rock.height,
                        facet(X_WB * lower_B.positions[a], X_WB * lower_B.positions[b],
                              X_WB * lower_B.positions[c]));
  return change * cell * cell;
}

double cut_sweep(ZMap& rock, const std::vector<SweepTool>& tools, const Pose& X_WB) {
  double removed = 0.0;
  for (const SweepTool& tool : tools) removed += cut_sweep(rock, tool.lower_B, X_WB);
  return removed;
}

ZMap z_map_of(const mesh::TriangleMesh& rock_W, double half, int cells) {
  ZMap map = flat_z_map(half, top_of(rock_W), cells);
  cut_sweep(map, rock_W, {});
  return map;
}

double height_at(const ZMap& rock, double x, double y) {
  const double last = rock.cells - 1.0;
  const double u = std::clamp((x + rock.half) / rock.cell() - 0.5, 0.0, last);
  const double v = std::clamp((y + rock.half) / rock.cell() - 0.5, 0.0, last);
  const int i = std::min(static_cast<int>(u), rock.cells - 2),
            j = std::min(static_cast<int>(v), rock.cells - 2);
  const double* at = rock.height.data() + static_cast<std::ptrdiff_t>(j) * rock.cells + i;
  return std::lerp(std::lerp(at[0], at[1], u - i),
                   std::lerp(at[rock.cells], at[rock.cells + 1], u - i), v - j);
}

}  // namespace tdbd::reference
