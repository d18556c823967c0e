#include "reference/literature/drag/spokes/langeveld_rock.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

/// The nodes within a rim, first to last.
struct NodeRange {
  int first, last;
};

NodeRange nodes_of(const Spokes& s, const RimEllipse& rim) {
  const double spacing = s.node_spacing();
  const double lo = std::ceil((rim.x0 - rim.half_width) / spacing - 0.5),
               hi = std::floor((rim.reach()) / spacing - 0.5);
  return {static_cast<int>(std::max(lo, 0.0)), static_cast<int>(std::min(hi, s.nodes - 1.0))};
}

const double* depths(const Spokes& s, int spoke) {
  return s.depth.data() + static_cast<std::ptrdiff_t>(spoke) * s.nodes;
}

/// The cut of the rim; calls lower(node, depth) for every node that it cuts.
template <class Lower>
CrossingCut over_nodes(const Spokes& s, int spoke, const RimEllipse& rim, CountedRock counted,
                       const Lower& lower) {
  const auto [first, last] = nodes_of(s, rim);
  const double* const depth = depths(s, spoke);
  CrossingCut cut;
  for (int j = first; j <= last; ++j) {
    const double r = s.node_radius(j), z = lower_branch(rim, r), over = z - depth[j];
    if (over <= 0.0) continue;
    const double height =
        counted == CountedRock::all_above ? over : std::min(over, z - upper_branch(rim, r));
    cut.area += height;
    cut.moment += height * r;
    cut.lowered += over;
    lower(j, z);
  }
  const double spacing = s.node_spacing();
  cut.area *= spacing, cut.moment *= spacing, cut.lowered *= spacing;
  return cut;
}

}  // namespace

LangeveldRock flat_rock(const std::vector<SpokeCutter>& cutters, double top, int spokes, int nodes,
                        double radius) {
  const double reach = widest_reach(cutters);
  return {flat_spokes(radius > 0.0 ? radius : reach, top, spokes, nodes),
          round_wall(spokes, reach)};
}

LangeveldRock fitting_rock(const std::vector<SpokeCutter>& cutters, double start, double top,
                           int spokes, int nodes, double radius) {
  LangeveldRock rock = flat_rock(cutters, top, spokes, nodes, radius);
  for (const SpokeCutter& c : cutters) {
    const RimEllipse rim = placed(c, {Vec3(0.0, 0.0, start), 0.0}).rim;
    for (int k = 0; k < spokes; ++k) cut_rock(rock, k, rim);
  }
  return rock;
}

CrossingCut rim_in_rock(const LangeveldRock& rock, int spoke, const RimEllipse& rim,
                        CountedRock counted) {
  return over_nodes(rock.bottom, spoke, rim, counted, [](int, double) {});
}

CrossingCut cut_rock(LangeveldRock& rock, int spoke, const RimEllipse& rim, CountedRock counted) {
  double* const depth =
      rock.bottom.depth.data() + static_cast<std::ptrdiff_t>(spoke) * rock.bottom.nodes;
  const CrossingCut cut =
      over_nodes(rock.bottom, spoke, rim, counted, [&](int node, double z) { depth[node] = z; });
  double& wall = rock.wall.radius[static_cast<std::size_t>(spoke)];
  wall = std::max(wall, rim.reach());
  return cut;
}

}  // namespace tdbd::reference
