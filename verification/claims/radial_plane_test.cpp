#include <algorithm>
#include <cmath>

#include "claims/example_bits.hpp"
#include "claims/force_runs.hpp"
#include "reference/bit/radial_plane_engagement.hpp"

/// Chapter 2: the three-dimensional model beside the classical plane, under one law.
namespace tdbd::claims::radial_plane_test {

/// Warren and Sinor's plane under the same law.
struct PlaneWeight {
  double normals = 0.0;   ///< N, sum of zeta eps A_i cos theta_i: the plane's weight
  double of_first = 0.0;  ///< N, of the cutter beside the axis
  double helix = 0.0;     ///< N, sum of eps A_i d/(2 pi r_i), which the plane does not know
};

PlaneWeight plane_weight(const simulation::Case& c) {
  const reference::Engagement plane =
      reference::radial_plane_engagement(c.bit, depth_of_cut(c), 0.05e-3);
  PlaneWeight w;
  for (std::size_t i = 0; i < c.bit.cutters.size(); ++i) {
    const double Ft = sharp_eps * plane.mean_area[i];
    const double normal = sharp_zeta * Ft * std::cos(c.bit.cutters[i].profile_angle);
    w.normals += normal;
    if (i == 0) w.of_first = normal;
    if (Ft > 0.0)
      w.helix += Ft * depth_of_cut(c) * plane.mean_area[i] / plane.volume_per_revolution[i];
  }
  return w;
}

/// What the normal forces of the faces of cutters first, ..., last carry of the weight.
double normals_of(const simulation::Case& c, const simulation::LoadStatisticsSummary& f,
                  std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (const simulation::PartLoadFigures& part : f.parts)
    for (std::size_t i = first; i <= last; ++i)
      if (part.name == simulation::cutter_name(c.bit.cutters[i]) + "/face")
        sum += part.normal.mean * std::cos(c.bit.cutters[i].profile_angle);
  return sum;
}

/// Relative difference between the three-dimensional forces and those of the planar model.
struct PlaneErrors {
  double weight = 0.0, with_helix = 0.0, first_cutter = 0.0, other_cutters = 0.0;
};

PlaneErrors plane_errors(const simulation::Case& c) {
  const PlaneWeight plane = plane_weight(c);
  const simulation::LoadStatisticsSummary f = loads_of(c);
  const double others = normals_of(c, f, 1, c.bit.cutters.size() - 1);
  return {std::abs(f.wob.mean / plane.normals - 1.0),
          std::abs(f.wob.mean / (plane.normals + plane.helix) - 1.0),
          std::abs(normals_of(c, f, 0, 0) / plane.of_first - 1.0),
          std::abs(others / (plane.normals - plane.of_first) - 1.0)};
}

/// Two things part the models: the weight that tangential forces carry on a helix, and the cutter
/// beside the axis, whose section sees 1 % less volume and 8 % less width than the plane gives it.
/// At 2 mm a revolution they cancel in part.
TEST(RadialPlane, gives_the_weight_that_forces_have) {
  const std::string claim = "chapter2/radial-plane";
  double worst = 0.0, worst_first = 0.0;
  for (const auto& [rate, limit] : std::vector<std::pair<double, double>>{
           {3.75, 0.02}, {7.5, 0.01}, {15.0, 5e-3}, {30.0, 5e-3}}) {
    const simulation::Case c = rock_case(
        "bit-b-steady",
        sharp({"time.step='2 ms'", fmt::format("motion.rate_of_penetration='{} m/h'", rate)}));
    const PlaneErrors errors = plane_errors(c);
    const std::string at = fmt::format(
        "Detournay's law, bit B, edges of 1 mm, {:.3g} mm a revolution: ", 1e3 * depth_of_cut(c));
    worst = std::max(worst, errors.weight);
    worst_first = std::max(worst_first, errors.first_cutter);
    record_bound(claim, at + "weight over the plane's with the helix added, distance from 1",
                 errors.with_helix, "1", 0.025);
    record_bound(claim,
                 at + "normal forces of all cutters but that beside the axis over the plane's, "
                      "distance from 1",
                 errors.other_cutters, "1", limit);
  }
  const std::string all = "Detournay's law, bit B, edges of 1 mm, 0.521 to 4.17 mm a revolution: ";
  record_bound(claim, all + "weight over the plane's, largest distance from 1", worst, "1", 0.04);
  record_bound(claim,
               all +
                   "normal force of the cutter beside the axis over the plane's, largest "
                   "distance from 1",
               worst_first, "1", 0.15);
}

}  // namespace tdbd::claims::radial_plane_test
