#include "bit/profile/bit_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "bit/cutter/cutter.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

bool counts(const Bit& bit, int cutter) {
  bool has_face = false, face_cuts = false, any_cuts = false;
  for (const Part& part : bit.parts) {
    if (part.cutter != cutter) continue;
    const bool cuts = part.cutting == Cutting::cuts;
    any_cuts = any_cuts || cuts;
    has_face = has_face || part.kind == PartKind::face;
    face_cuts = face_cuts || (part.kind == PartKind::face && cuts);
  }
  return has_face ? face_cuts : any_cuts;
}

}  // namespace

std::vector<int> cutting_at_start(const Bit& bit) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    if (counts(bit, static_cast<int>(i))) indices.push_back(static_cast<int>(i));
  return indices;
}

std::vector<Cutter> cutters_at(const Bit& bit, std::span<const int> indices) {
  std::vector<Cutter> cutters;
  for (const int i : indices) cutters.push_back(bit.cutters[static_cast<std::size_t>(i)]);
  return cutters;
}

std::vector<double> expand_to_all_cutters(const Bit& bit, std::span<const int> indices,
                                          std::span<const double> values, double otherwise) {
  std::vector<double> all(bit.cutters.size(), otherwise);
  for (std::size_t k = 0; k < indices.size(); ++k)
    all[static_cast<std::size_t>(indices[k])] = values[k];
  return all;
}

std::string excluded_cutter_names(const Bit& bit) {
  const std::vector<int> counted = cutting_at_start(bit);
  std::string names;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    if (!std::ranges::binary_search(counted, static_cast<int>(i)))
      names += (names.empty() ? "cutter-" : ", cutter-") + std::to_string(bit.cutters[i].id);
  return names;
}

namespace {

/// The fraction of a revolution by which `earlier` passes before `c`. The bit turns about +z, so
/// larger azimuths pass first; cutters at the same azimuth pass in the order of the table.
double share_before(const RimReach& earlier, const RimReach& c, bool is_listed_before) {
  const double share = (earlier.azimuth - c.azimuth) / full_turn;
  const double fraction = share - std::floor(share);
  return fraction == 0.0 && !is_listed_before ? 1.0 : fraction;
}

/// Height that cutter c removes in column i.
double height(const std::vector<std::vector<RimReach>>& reach, std::size_t c, std::size_t i,
              double advance) {
  const RimReach& own = reach[c][i];
  if (!own.reached()) return 0.0;
  double h = advance;
  for (std::size_t k = 0; k < reach.size() && h > 0.0; ++k)
    if (k != c && reach[k][i].reached())
      h = std::min(h, own.z - reach[k][i].z + advance * share_before(reach[k][i], own, k < c));
  return std::max(0.0, h);
}

/// Length of a rim in column i, from its slope between the neighbouring columns that it reaches.
double rim_length(const std::vector<RimReach>& rim, std::size_t i, double width) {
  const std::size_t a = i > 0 && rim[i - 1].reached() ? i - 1 : i;
  const std::size_t b = i + 1 < rim.size() && rim[i + 1].reached() ? i + 1 : i;
  if (a == b) return width;
  const double slope = (rim[b].z - rim[a].z) / (static_cast<double>(b - a) * width);
  return width * std::hypot(1.0, slope);
}

}  // namespace

Engagement engagement(const std::vector<Cutter>& cutters, double advance, double column_width) {
  if (cutters.empty()) return {};
  const RimReaches rims = rim_reaches(cutters, column_width);
  const auto& reach = rims.of_cutter;
  const double width = rims.width;
  const std::size_t columns = reach.front().size();
  Engagement e{std::vector<double>(cutters.size()), std::vector<double>(cutters.size()),
               std::vector<double>(cutters.size()), std::vector<int>(columns), width};
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t c = 0; c < cutters.size(); ++c) {
      const double h = height(reach, c, i, advance);
      e.area[c] += h * width;
      e.volume[c] += h * width * full_turn * (static_cast<double>(i) + 0.5) * width;
      if (!(h > 0.0)) continue;
      e.edge[c] += rim_length(reach[c], i, width);
      ++e.cutting[i];
    }
  return e;
}

namespace {

/// The largest s at which a cutter's line, r = tip_r + s sin, z = tip_z + s cos, meets a rim within
/// `range` of the tip; -infinity if it does not.
double farthest_crossing(const Cutter& c, const std::vector<Vec3>& rim, double range) {
  const double n_r = std::sin(c.profile_angle), n_z = std::cos(c.profile_angle);
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Vec3 &a = rim[k], &b = rim[(k + 1) % rim.size()];
    const double ar = a.x() - c.tip_radius, az = a.z() + c.tip_height;
    const double br = b.x() - c.tip_radius, bz = b.z() + c.tip_height;
    const double beside_a = ar * n_z - az * n_r, beside_b = br * n_z - bz * n_r;
    if ((beside_a < 0.0) == (beside_b < 0.0)) continue;
    const double w = beside_a / (beside_a - beside_b);
    const double s = std::lerp(ar * n_r + az * n_z, br * n_r + bz * n_z, w);
    if (std::abs(s) <= range) farthest = std::max(farthest, s);
  }
  return farthest;
}

}  // namespace

std::vector<double> exposures(const std::vector<Cutter>& cutters) {
  std::vector<std::vector<Vec3>> rims;
  rims.reserve(cutters.size());
  for (const Cutter& c : cutters) rims.push_back(turned_outline(c, rim_points));
  std::vector<double> exposure(cutters.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    double envelope = -std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < rims.size(); ++other)
      if (other != k)
        envelope =
            std::max(envelope, farthest_crossing(cutters[k], rims[other], cutters[k].diameter));
    if (std::isfinite(envelope)) exposure[k] = -envelope;
  }
  return exposure;
}

std::vector<double> overlaps(const std::vector<Cutter>& cutters) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < cutters.size(); ++k)
    if (cutters[k].under_exposure == 0.0) order.push_back(k);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) {
    return std::tuple(cutters[k].tip_radius, cutters[k].tip_height);
  });
  std::vector<double> overlap(cutters.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Cutter &a = cutters[order[k - 1]], &b = cutters[order[k]];
    const double gap = std::hypot(b.tip_radius - a.tip_radius, b.tip_height - a.tip_height);
    overlap[order[k - 1]] = 1.0 - gap / (0.5 * (a.diameter + b.diameter));
  }
  return overlap;
}

Vec3 imbalance_vector(const std::vector<Cutter>& cutters, const std::vector<double>& areas) {
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    sum += areas[k] * profile_normal_B(cutters[k]);
    total += areas[k];
  }
  sum.z() = 0.0;
  return total > 0.0 ? Vec3(sum / total) : Vec3(Vec3::Zero());
}

double imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas) {
  return imbalance_vector(cutters, areas).norm();
}

double planar_imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas,
                        double normal_ratio) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    const Vec3 way(-std::sin(cutters[k].azimuth), std::cos(cutters[k].azimuth), 0.0);
    sum -= areas[k] * (normal_ratio * profile_normal_B(cutters[k]) + way);
  }
  const double weight = -sum.z();
  return weight > 0.0 ? sum.head<2>().norm() / weight : std::numeric_limits<double>::quiet_NaN();
}

PlanarBalance planar_balance(const std::vector<Cutter>& cutters, const std::vector<double>& areas,
                             double normal_ratio) {
  PlanarBalance b;
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    const Vec3 way(-std::sin(cutters[k].azimuth), std::cos(cutters[k].azimuth), 0.0);
    b.normal -= areas[k] * normal_ratio * profile_normal_B(cutters[k]);
    b.drag -= areas[k] * way;
  }
  b.weight = -b.normal.z();
  b.normal.z() = 0.0;
  return b;
}

double mean_redundancy(const std::vector<int>& cutting) {
  double sum = 0.0, weight = 0.0;
  for (std::size_t k = 0; k < cutting.size(); ++k) {
    const double ring = 2.0 * static_cast<double>(k) + 1.0;
    sum += ring * cutting[k];
    weight += ring;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace tdbd::bit
