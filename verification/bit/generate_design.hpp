#pragma once

#include "bit/generate.hpp"
#include "bit/pdc/pdc_generator.hpp"

namespace tdbd::bit {

/// Share of a diameter by which neighbours overlap at least in any_design.
inline constexpr double least_overlap = 0.2;

inline RegionLaw any_law(double lo, double hi) {
  return {number(lo, hi), number(lo, hi), number(lo, hi), number(lo, hi)};
}

inline ProfileDesign any_profile() {
  ProfileDesign p;
  p.gage_radius = number(0.07, 0.17);
  p.cone_angle = number(5 * degree, 28 * degree);
  p.nose_place = number(0.5, 0.68) * p.gage_radius;
  p.nose_radius = number(0.25, 0.4) * p.gage_radius;
  p.shoulder_angle = number(20 * degree, 45 * degree);
  p.gage_length = 0.6 * p.gage_radius;
  return p;
}

/// 4 to 8 blades; from 6 on every second one starts outside the centre.
inline std::vector<BladeDesign> any_blades(double gage_radius) {
  const int n = *rc::gen::inRange(4, 9);
  std::vector<BladeDesign> blades(n);
  for (int k = 0; k < n; ++k) {
    blades[k].azimuth = 2 * pi * k / n;
    if (n >= 6 && k % 2 == 1) blades[k].start = 0.3 * gage_radius;
  }
  return blades;
}

/// A design that usually can be laid out: rakes, sizes and overlaps differ between the regions.
inline PdcDesign any_design() {
  PdcDesign d;
  d.profile = any_profile();
  const double gage_radius = d.profile.gage_radius;
  d.blades = any_blades(gage_radius);
  const double size = number(0.09, 0.13) * gage_radius;
  d.diameter = {size, number(0.9, 1.0) * size, number(0.8, 1.0) * size, 0.8 * size};
  d.first_radius = number(0.25, 0.35) * size;
  d.spiral = number(-10 * degree, 20 * degree);
  const double outer = 1.0 - 1.8 / static_cast<double>(d.blades.size());
  d.overlap = {number(least_overlap, 0.5), number(least_overlap, 0.5), number(least_overlap, outer),
               number(least_overlap, outer)};
  d.back_rake = any_law(8 * degree, 30 * degree);
  d.side_rake = any_law(-4 * degree, 4 * degree);
  d.wear = any_law(0.0, 0.05 * size);
  d.shape.length = 0.9 * size;
  d.shape.chamfer = *rc::gen::element(0.0, 0.02 * size);
  d.shape.land = d.shape.chamfer;
  if (*rc::gen::arbitrary<bool>()) d.blades[0].backups = Backups::behind_face_cutters;
  d.backups = {0.4 * gage_radius, gage_radius, 0.05 * size, 1.5 * size};
  d.gage.cutters = *rc::gen::inRange(0, 3);
  return d;
}

/// Its cutters; designs that do not fit are thrown away.
inline std::vector<Cutter> laid_out(const PdcDesign& d) {
  const Layout layout = make_layout(d);
  RC_PRE(layout.problems.empty());
  return layout.cutters;
}

/// The design of cases/bits/generated.toml but for its back-ups.
inline PdcDesign plain_design() {
  PdcDesign d;
  d.profile = {107.95e-3, 18 * degree, 66e-3, 38e-3, 35 * degree, 50e-3};
  for (int k = 0; k < 6; ++k) d.blades.push_back({k * pi / 3, k % 2 * 30e-3, Backups::none});
  d.first_radius = 4e-3;
  d.shape = chamfered();
  d.diameter = {13.44e-3, 13.44e-3, 13.44e-3, 13.44e-3};
  d.overlap = {0.55, 0.66, 0.72, 0.72};
  d.back_rake = {15 * degree, 17 * degree, 20 * degree, 25 * degree};
  return d;
}

}  // namespace tdbd::bit
