#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/literature/drag/drag_input.hpp"
#include "reference/literature/drag/planes/behr.hpp"
#include "reference/literature/drag/planes/behr_crossings.hpp"

namespace tdbd::reference {
namespace {

const std::string behr_name = "Behr et al.";

void require_behr(const std::vector<bit::Cutter>& cutters, const BehrOptions& options) {
  require_cutters(behr_name, cutters);
  require_positive(behr_name, "planes", options.planes);
  require_positive(behr_name, "nodes on a plane", options.nodes);
  require_positive(behr_name, "radius to which planes reach (m)", options.radius);
  require_one_each(behr_name, "normal ratios", options.normal_ratio.size(), cutters.size());
  require_one_each(behr_name, "areas of flats", options.flat_area.size(), cutters.size());
}

/// The deepest outline at each node. Nodes without an outline get the smallest of those depths, or
/// 0 if all outlines pass between the nodes.
std::vector<double> untouched_profile(const std::vector<CutterRim>& rims, const Spokes& rock) {
  std::vector<RimEllipse> outlines;
  outlines.reserve(rims.size());
  for (const CutterRim& rim : rims)
    outlines.push_back(rim_ellipse(rim, rim.motion_B.cross(Vec3::UnitZ())));
  std::vector<double> depth(at(rock.nodes), no_depth);
  double shallowest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < rock.nodes; ++k) {
    double& z = depth[at(k)];
    for (const RimEllipse& e : outlines) z = std::max(z, depth_at(e, rock.node_radius(k)));
    if (z != no_depth) shallowest = std::min(shallowest, z);
  }
  const double level = std::isfinite(shallowest) ? shallowest : 0.0;
  std::replace(depth.begin(), depth.end(), no_depth, level);
  return depth;
}

}  // namespace

BehrState behr_start(const std::vector<bit::Cutter>& cutters, const BitPlace& place,
                     const BehrOptions& options) {
  require_behr(cutters, options);
  BehrState s;
  for (const bit::Cutter& c : cutters) s.rims.push_back(cutter_rim(c, 0.0));
  s.bottom = flat_spokes(options.radius, 0.0, options.planes, options.nodes);
  const std::vector<double> depth = untouched_profile(s.rims, s.bottom);
  for (int k = 0; k < options.planes; ++k) {
    s.planes.push_back(spoke_plane(k, options.planes));
    for (int j = 0; j < options.nodes; ++j)
      s.bottom.depth[at(k * options.nodes + j)] = place.p_WB.z() + depth[at(j)];
  }
  s.place = place;
  for (const CutterRim& rim : s.rims) {
    const Vec3 tip_W = place.p_WB + turned(place, rim.tip_B);
    s.azimuth.push_back(std::atan2(tip_W.y(), tip_W.x()));
  }
  s.last.resize(cutters.size());
  s.since.resize(cutters.size());
  return s;
}

}  // namespace tdbd::reference
