#include "reference/literature/surface/z_map.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

using Vec2 = Eigen::Vector2d;

/// A triangle of the part, in space.
struct PartFacet {
  Vec3 a, b, c;
};

struct CellRange {
  int first, last;  ///< inclusive
};

/// Cells along x (axis 0) or y (axis 1) that the facet may cover.
CellRange covered(const ZMap& rock, const PartFacet& f, int axis) {
  const auto [lo, hi] = std::minmax({f.a[axis], f.b[axis], f.c[axis]});
  const int first = static_cast<int>(std::floor((lo + rock.half) / rock.cell()));
  const int last = static_cast<int>(std::floor((hi + rock.half) / rock.cell()));
  return {std::max(first, 0), std::min(last, rock.cells - 1)};
}

double plan_cross(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Depth of the facet at (x, y) if it covers that point, otherwise `otherwise`.
double depth_at(const PartFacet& f, const Vec2& x, double otherwise) {
  const Vec2 a = f.a.head<2>(), ab = f.b.head<2>() - a, ac = f.c.head<2>() - a;
  const double area = plan_cross(ab, ac);
  if (area == 0.0) return otherwise;  // vertical: its neighbours cover its cells
  const double beta = plan_cross(x - a, ac) / area, gamma = plan_cross(ab, x - a) / area;
  if (beta < 0.0 || gamma < 0.0 || beta + gamma > 1.0) return otherwise;
  return f.a.z() + beta * (f.b.z() - f.a.z()) + gamma * (f.c.z() - f.a.z());
}

/// Lowers the cells under one facet. Returns the sum of the changes of their heights.
double cut_facet(ZMap& rock, const PartFacet& f) {
  const CellRange columns = covered(rock, f, 0), rows = covered(rock, f, 1);
  double change = 0.0;
  for (int row = rows.first; row <= rows.last; ++row)
    for (int column = columns.first; column <= columns.last; ++column) {
      double& height = rock.height[row * rock.cells + column];
      const double depth = depth_at(f, {rock.centre(column), rock.centre(row)}, height);
      change += std::max(0.0, depth - height);
      height = std::max(height, depth);
    }
  return change;
}

}  // namespace

ZMap flat_z_map(double half, double z, int cells) {
  return {half, cells, std::vector<double>(static_cast<std::size_t>(cells) * cells, z)};
}

double cut(ZMap& rock, const mesh::TriangleMesh& part_P, const Pose& X_WP) {
  double change = 0.0;
  for (const mesh::Triangle& t : part_P.triangles)
    change += cut_facet(rock, {X_WP * part_P.positions[t[0]], X_WP * part_P.positions[t[1]],
                               X_WP * part_P.positions[t[2]]});
  return change * rock.cell() * rock.cell();
}

}  // namespace tdbd::reference
