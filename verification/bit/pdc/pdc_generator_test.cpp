#include "bit/pdc/pdc_generator.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bit/body/blade_body.hpp"
#include "bit/generate_design.hpp"
#include "reference/bit/heel_drag.hpp"

namespace tdbd::bit::pdc_generator_test {

constexpr double on_profile = 1e-12;  ///< of the gage radius: rounding of a chain of arcs

/// Distance of a point from the profile, by its regions' implicit equations.
double distance_from_profile(const ProfileDesign& p, double r, double h) {
  const double cone_end = p.nose_place - p.nose_radius * std::sin(p.cone_angle);
  const double nose_end = p.nose_place + p.nose_radius * std::sin(p.shoulder_angle);
  const double rs = shoulder_radius(p), drop = p.nose_radius - rs;
  if (r <= cone_end) {
    const double at_end = p.nose_radius * (1 - std::cos(p.cone_angle));
    return (h - at_end) * std::cos(p.cone_angle) - (cone_end - r) * std::sin(p.cone_angle);
  }
  if (r <= nose_end) return std::hypot(r - p.nose_place, h - p.nose_radius) - p.nose_radius;
  const double centre_r = p.nose_place + drop * std::sin(p.shoulder_angle);
  const double centre_h = p.nose_radius - drop * std::cos(p.shoulder_angle);
  if (h <= centre_h) return std::hypot(r - centre_r, h - centre_h) - rs;
  return r - p.gage_radius;
}

/// The tip without its under-exposure.
ProfileSpot exposed_tip(const Cutter& c) {
  return {c.tip_radius + c.under_exposure * std::sin(c.profile_angle),
          c.tip_height - c.under_exposure * std::cos(c.profile_angle), c.profile_angle};
}

RC_GTEST_PROP(PdcGenerator, gives_azimuths_within_one_turn, ()) {
  for (const Cutter& c : laid_out(any_design())) RC_ASSERT(c.azimuth >= 0.0 && c.azimuth <= 2 * pi);
}

RC_GTEST_PROP(PdcGenerator, puts_every_tip_on_the_profile, ()) {
  const PdcDesign d = any_design();
  for (const Cutter& c : laid_out(d)) {
    const ProfileSpot tip = exposed_tip(c);
    RC_ASSERT(std::abs(distance_from_profile(d.profile, tip.r, tip.h)) <
              on_profile * d.profile.gage_radius);
    RC_ASSERT((c.X_BC * tip_C(c) - tip_B(c)).norm() < on_profile * d.profile.gage_radius);
  }
}

/// Whether a point lies inside a cutter's cylinder by more than `slack`.
bool inside(const Cutter& c, const Vec3& x_B, double slack) {
  const Vec3 x = c.X_BC.R.transpose() * (x_B - c.X_BC.p);
  return x.x() < -slack && x.x() > slack - c.length &&
         std::hypot(x.y(), x.z()) < c.diameter / 2 - slack;
}

/// Whether a point of a's surface, of a thousand, lies in b.
bool pokes_into(const Cutter& a, const Cutter& b) {
  for (int i = 0; i <= 15; ++i)
    for (int k = 0; k < 48; ++k) {
      const double angle = 2 * pi * k / 48;
      const Vec3 round(0, std::sin(angle), std::cos(angle));
      const Vec3 side = a.diameter / 2 * round - Vec3(a.length * i / 15, 0, 0);
      const Vec3 front = a.diameter / 2 * i / 15 * round, back = front - Vec3(a.length, 0, 0);
      for (const Vec3& x_C : {side, front, back})
        if (inside(b, a.X_BC * x_C, 0.0)) return true;
    }
  return false;
}

RC_GTEST_PROP(PdcGenerator, lets_no_two_cutters_overlap, ()) {
  const std::vector<Cutter> cutters = laid_out(any_design());
  for (const Cutter& a : cutters)
    for (const Cutter& b : cutters)
      if (a.id != b.id && (a.X_BC.p - b.X_BC.p).norm() < 2 * a.diameter)
        RC_ASSERT(!pokes_into(a, b));
}

/// What stays over the profile at a spot when this cutter has passed: along the cutter's normal,
/// over its edge, an ellipse of half axes D/2 and D/2 cos(back rake). Infinite beside it.
double uncut(const Cutter& c, const ProfileSpot& spot) {
  const double sine = std::sin(c.profile_angle), cosine = std::cos(c.profile_angle);
  const double dr = spot.r - c.tip_radius, dh = spot.h - c.tip_height;
  const double u = cosine * dr + sine * dh, v = sine * dr - cosine * dh, half = c.diameter / 2;
  if (std::abs(u) >= half) return 1.0;
  return v + std::cos(c.back_rake) * (half - std::sqrt(half * half - u * u));
}

/// Neighbours that overlap by a fifth leave cusps of a fifth of a diameter.
RC_GTEST_PROP(PdcGenerator, covers_every_radius_from_the_centre_to_the_gage, ()) {
  const PdcDesign d = any_design();
  const std::vector<Cutter> cutters = laid_out(d);
  const double cusp = 0.5 - std::sqrt(0.25 - 0.25 * (1 - least_overlap) * (1 - least_overlap));
  for (int k = 0; k <= 200; ++k) {
    const ProfileSpot spot = spot_at(d.profile, region_ends(d.profile)[2] * k / 200);
    double least = 1.0;
    for (const Cutter& c : cutters)
      if (c.under_exposure == 0.0) least = std::min(least, uncut(c, spot));
    RC_ASSERT(least < cusp * d.diameter.cone + 1e-12);
  }
}

RC_GTEST_PROP(PdcGenerator, spaces_neighbours_no_wider_than_requested, ()) {
  const PdcDesign d = any_design();
  const std::vector<Cutter> cutters = laid_out(d);
  const auto last = std::ranges::find(cutters, true, [&](const Cutter& c) {
    return std::abs(c.profile_angle - pi / 2) < 1e-12 || c.under_exposure > 0.0;
  });
  RC_ASSERT(last != cutters.end());
  for (auto c = cutters.begin(); c != last; ++c) {
    const double gap = std::hypot(c[1].tip_radius - c->tip_radius, c[1].tip_height - c->tip_height);
    const double widest = (1 - least_overlap) * std::max(c->diameter, c[1].diameter);
    RC_ASSERT(gap < widest * (1 + 1e-12));
  }
  RC_ASSERT(std::abs(last->tip_radius - d.profile.gage_radius) < on_profile);
}

RC_GTEST_PROP(PdcGenerator, gives_the_requested_rakes_wear_and_sizes, ()) {
  const PdcDesign d = any_design();
  const double cone_end =
      d.profile.nose_place - d.profile.nose_radius * std::sin(d.profile.cone_angle);
  const auto law_on_cone = [&](const RegionLaw& law, double r) {
    return law.axis + (law.nose - law.axis) * r / cone_end;
  };
  for (const Cutter& c : laid_out(d)) {
    if (c.under_exposure > 0.0) continue;
    if (c.zone == "cone") {
      RC_ASSERT(std::abs(c.back_rake - law_on_cone(d.back_rake, c.tip_radius)) < 1e-13);
      RC_ASSERT(std::abs(c.side_rake - law_on_cone(d.side_rake, c.tip_radius)) < 1e-13);
      RC_ASSERT(std::abs(c.wear - law_on_cone(d.wear, c.tip_radius)) < 1e-13);
      RC_ASSERT(std::abs(c.diameter - d.diameter.cone) < 1e-16);
    }
    if (c.zone == "gage") {
      RC_ASSERT(std::abs(c.back_rake - d.back_rake.gage) < 1e-15);
      RC_ASSERT(std::abs(c.diameter - d.diameter.gage) < 1e-16);
    }
    const BladeDesign& blade = d.blades[c.blade - 1];
    const double trail = d.spiral * c.tip_radius / d.profile.gage_radius;
    RC_ASSERT(std::abs(std::remainder(c.azimuth - blade.azimuth + trail, 2 * pi)) < 1e-13);
    RC_ASSERT(c.zone == "gage" || c.tip_radius >= blade.start);
  }
}

RC_GTEST_PROP(PdcGenerator, puts_backups_behind_face_cutters_of_their_blade, ()) {
  PdcDesign d = any_design();
  for (BladeDesign& b : d.blades) b.backups = Backups::behind_face_cutters;
  d.backups.from = 0.6 * d.profile.gage_radius;
  d.gage.cutters = 0;
  const std::vector<Cutter> cutters = laid_out(d);
  long wanted = 0;
  for (const Cutter& c : cutters) {
    if (c.under_exposure == 0.0) {
      wanted += c.tip_radius >= d.backups.from && c.tip_radius <= d.backups.to;
      continue;
    }
    const auto face = std::ranges::find_if(cutters, [&](const Cutter& f) {
      return std::abs(f.tip_radius - exposed_tip(c).r) < 1e-12 && f.blade == c.blade;
    });
    RC_ASSERT(face != cutters.end());
    const double lag = std::remainder(face->azimuth - c.azimuth, 2 * pi) * c.tip_radius;
    RC_ASSERT(std::abs(lag - d.backups.behind) < 1e-13);
  }
  RC_ASSERT(wanted ==
            std::ranges::count_if(cutters, [](const Cutter& c) { return c.under_exposure > 0.0; }));
}

/// A whole bit of a design with pads and blades, worn and spiralled as specified by the design.
Bit whole_bit(const PdcDesign& d) {
  PdcOptions options;
  options.pads.count = static_cast<int>(d.blades.size());
  options.pads.under_gage = 0.01 * d.profile.gage_radius;
  options.blades = BladeOptions{};
  options.blades->exposure = 0.3 * d.diameter.gage;
  options.blades->slot_depth = 0.08 * d.profile.gage_radius;
  const std::vector<Cutter> cutters = laid_out(d);
  RC_PRE(blade_problems(cutters, *options.blades, d.profile.gage_radius).empty());
  return pdc_bit("whole", cutters, options);
}

double reach_of(const Part& part) {
  double reach = 0.0;
  for (const Vec3& x_P : part.mesh_P.positions)
    reach = std::max(reach, (part.X_BP * x_P).head<2>().norm());
  return reach;
}

/// Pads stay under the gage by the requested distance, the blades by their exposure; wear reduces
/// the radius of pads only by what it takes from the gage cutters.
RC_GTEST_PROP(PdcGenerator, keeps_pads_and_blades_under_the_gage, ()) {
  const PdcDesign d = any_design();
  const Bit bit = whole_bit(d);
  const double under = 0.01 * d.profile.gage_radius;
  for (const Part& part : bit.parts) {
    if (part.kind == PartKind::gage_pad)
      RC_ASSERT(std::abs(reach_of(part) - (bit.gage_radius - under)) < 1e-12);
    if (part.kind == PartKind::bit_body)
      RC_ASSERT(reach_of(part) < d.profile.gage_radius - bit.blades->exposure + 1e-12);
  }
  RC_ASSERT(bit.gage_radius < d.profile.gage_radius + 5e-5);
  const double worn = std::max({d.wear.shoulder, d.wear.gage, d.wear.nose});
  RC_ASSERT(bit.gage_radius > d.profile.gage_radius - worn - 1e-12);
}

/// The blades follow the spiral: at the place of every face cutter its blade's front has the
/// cutter's azimuth.
RC_GTEST_PROP(PdcGenerator, lets_blades_follow_their_cutters, ()) {
  const PdcDesign d = any_design();
  const std::vector<Cutter> cutters = laid_out(d);
  const BladeShape shape = blade_shape(cutters, {});
  for (const Cutter& c : cutters) {
    if (c.under_exposure > 0.0) continue;
    const auto blade = std::ranges::find(shape.blades, c.blade, &BladeStrip::blade);
    RC_ASSERT(blade != shape.blades.end());
    const double front = front_at(*blade, place_of(shape, c));
    RC_ASSERT(std::abs(std::remainder(front - c.azimuth, 2 * pi)) < 1e-14);
  }
}

TEST(PdcGenerator, spreads_neighbours_over_the_blades) {
  EXPECT_EQ(blade_order(6), (std::vector{0, 3, 1, 4, 2, 5}));
  EXPECT_EQ(blade_order(5), (std::vector{0, 2, 4, 1, 3}));
  EXPECT_EQ(blade_order(1), std::vector{0});
  for (int n = 1; n < 20; ++n) {
    std::vector<int> order = blade_order(n);
    std::ranges::sort(order);
    for (int k = 0; k < n; ++k) EXPECT_EQ(order[k], k) << n;
  }
}

TEST(PdcGenerator, starts_and_ends_where_it_should) {
  const Layout layout = make_layout(plain_design());
  ASSERT_TRUE(layout.problems.empty()) << layout.problems[0].found;
  EXPECT_EQ(layout.cutters.size(), 38u);
  EXPECT_NEAR(layout.cutters.front().tip_radius, 4e-3, 1e-18);
  EXPECT_NEAR(layout.cutters[31].tip_radius, 107.95e-3, 1e-16);
  EXPECT_EQ(pdc_bit("plain", layout.cutters, {}).parts.size(), 38u * 3 + 1);
  EXPECT_NEAR(pdc_bit("plain", layout.cutters, {}).gage_radius, 107.95e-3, 1e-15);
}

/// Near the axis no cutter of any bit is relieved: there the path bends too much.
TEST(PdcGenerator, relieves_every_cutter_away_from_the_axis) {
  const Bit bit = pdc_bit("plain", make_layout(plain_design()).cutters, {});
  const std::vector<double> drag = reference::heel_drag(bit, 2e-3);
  for (std::size_t k = 0; k < drag.size(); ++k)
    EXPECT_TRUE(bit.cutters[k].tip_radius < 0.01 || drag[k] < 0.0) << k + 1 << ": " << drag[k];
}

}  // namespace tdbd::bit::pdc_generator_test
