#include "reference/literature/surface/spokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reference/literature/surface/spoke_plane.hpp"

namespace tdbd::reference {
namespace {

constexpr double pi = std::numbers::pi;

struct Span {
  double lo = INFINITY, hi = -INFINITY;

  void add(double x) {
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
};

/// Spokes that may meet a facet, from first to last. Numbers continue past the full turn.
struct Range {
  int first, last;
};

using Facet = std::array<Vec3, 3>;

bool is_around_axis(const Facet& f) {
  const auto turns_left = [](const Vec3& a, const Vec3& b) {
    return a.x() * b.y() - a.y() * b.x() >= 0.0;
  };
  const bool first = turns_left(f[0], f[1]);
  return first == turns_left(f[1], f[2]) && first == turns_left(f[2], f[0]);
}

Range spokes_across(const Spokes& rock, const Facet& f) {
  if (is_around_axis(f)) return {0, rock.spokes - 1};
  const double middle = std::atan2(f[0].y(), f[0].x());
  Span angle;
  for (const Vec3& x : f)
    angle.add(std::remainder(std::atan2(x.y(), x.x()) - middle, 2.0 * pi) + middle);
  const double per_spoke = rock.spokes / (2.0 * pi);
  return {static_cast<int>(std::ceil(angle.lo * per_spoke)),
          static_cast<int>(std::floor(angle.hi * per_spoke))};
}

/// The interval of a facet along a spoke: radius, and depth at both ends.
struct Cut {
  double r_lo = INFINITY, r_hi = -INFINITY, z_lo = 0.0, z_hi = 0.0;

  void add(double r, double z) {
    if (r < r_lo) r_lo = r, z_lo = z;
    if (r > r_hi) r_hi = r, z_hi = z;
  }
  double at(double r) const {
    return r_hi > r_lo ? z_lo + (r - r_lo) / (r_hi - r_lo) * (z_hi - z_lo) : z_lo;
  }
};

/// The intersection of a facet with the plane of a spoke.
Cut cut_by_plane(const Facet& f, const SpokePlane& plane) {
  Cut cut;
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto x = crossing(plane, f[i], f[(i + 1) % 3])) cut.add(x->x(), x->y());
  return cut;
}

double cut_spoke(Spokes& rock, int spoke, const Facet& f) {
  const Cut cut = cut_by_plane(f, spoke_plane(spoke, rock.spokes));
  if (cut.r_lo > cut.r_hi) return 0.0;
  const double spacing = rock.node_spacing();
  const int first = static_cast<int>(std::ceil(std::max(cut.r_lo / spacing - 0.5, 0.0)));
  const double last = std::min(cut.r_hi / spacing - 0.5, rock.nodes - 1.0);
  double change = 0.0;
  for (int node = first; node <= last; ++node) {
    const double r = rock.node_radius(node), z = cut.at(r);
    double& depth = rock.depth[static_cast<std::size_t>(spoke) * rock.nodes + node];
    change += std::max(0.0, z - depth) * r;
    depth = std::max(depth, z);
  }
  return change;
}

}  // namespace

double Spokes::azimuth(int spoke) const { return spoke_azimuth(spoke, spokes); }

double spoke_spacing(const Spokes& rock, double r) { return 2.0 * pi * r / rock.spokes; }

Spokes flat_spokes(double radius, double z, int spokes, int nodes) {
  return {radius, spokes, nodes, std::vector<double>(static_cast<std::size_t>(spokes) * nodes, z)};
}

Spokes spokes_of(const mesh::TriangleMesh& rock_W, double radius, int spokes, int nodes) {
  Spokes rock = flat_spokes(radius, top_of(rock_W), spokes, nodes);
  cut_sweep(rock, rock_W, {});
  return rock;
}

double cut_sweep(Spokes& rock, const mesh::TriangleMesh& lower_B, const Pose& X_WB) {
  double change = 0.0;
  for (const auto& [a, b, c] : lower_B.triangles) {
    const Facet f{X_WB * lower_B.positions[a], X_WB * lower_B.positions[b],
                  X_WB * lower_B.positions[c]};
    const Range range = spokes_across(rock, f);
    for (int k = range.first; k <= range.last; ++k)
      change += cut_spoke(rock, (k % rock.spokes + rock.spokes) % rock.spokes, f);
  }
  return change * rock.node_spacing() * 2.0 * pi / rock.spokes;
}

double cut_sweep(Spokes& rock, const std::vector<SweepTool>& tools, const Pose& X_WB) {
  double removed = 0.0;
  for (const SweepTool& tool : tools) removed += cut_sweep(rock, tool.lower_B, X_WB);
  return removed;
}

double depth_at(const Spokes& rock, double x, double y) {
  const double along =
      std::clamp(std::hypot(x, y) / rock.node_spacing() - 0.5, 0.0, rock.nodes - 1.0);
  const double turn = std::atan2(y, x) / (2.0 * pi),
               around = (turn < 0.0 ? turn + 1.0 : turn) * rock.spokes;
  const int i = std::min(static_cast<int>(along), rock.nodes - 2), k = static_cast<int>(around);
  const auto on_spoke = [&](int spoke) {
    const double* d =
        rock.depth.data() + static_cast<std::ptrdiff_t>(spoke % rock.spokes) * rock.nodes + i;
    return std::lerp(d[0], d[1], along - i);
  };
  return std::lerp(on_spoke(k), on_spoke(k + 1), around - k);
}

}  // namespace tdbd::reference
