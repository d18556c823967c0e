#include "simulation/step/cuts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::cuts_test {

/// Bit B under forces, a tenth of a revolution on.
const Simulation& drilling_bit_b() {
  static const Simulation made = [] {
    const Case c =
        read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml", {"rock.edge_length='3 mm'"});
    Simulation s = start(c);
    for (int i = 0; i < 50; ++i) step(c, s);
    return s;
  }();
  return made;
}

const bit::Bit& bit_b() {
  static const bit::Bit bit =
      read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml", {"rock.edge_length='3 mm'"}).bit;
  return bit;
}

/// 2 (1 - cos(pi/64)), of the radius: the rim has 64 sides, and a side's middle stands for what of
/// it is engaged.
constexpr double of_sides = 2.41e-3;

/// Distance of the centroid of an arc of the rim from its centre: radius times sin a/a, a half the
/// arc's angle.
double arc_centroid(const bit::Cutter& c, double length) {
  const double a = length / c.diameter;
  return 0.5 * c.diameter * std::sin(a) / a;
}

/// In the plane of the rim, on the side of the rock, and as far from the centre as that of an arc,
/// less what the sides of a polygon are inside their circle (seen: 1.3e-3 to 2.0e-3).
TEST(Cuts, have_the_centroid_of_the_engaged_edge_of_an_arc_on_the_rim) {
  constexpr double plane = 1e-12;  // m
  int engaged = 0;
  for (std::size_t i = 0; i < bit_b().cutters.size(); ++i) {
    const bit::Cutter& c = bit_b().cutters[i];
    const rock::Section& s = drilling_bit_b().work.measures.sections[i];
    if (!(s.engaged_edge > 0.0)) continue;
    const Vec3 x_C = inverse(bit::cutter_pose(c)) * s.edge_centroid_B;
    const double far = std::hypot(x_C.y(), x_C.z()), arc = arc_centroid(c, s.engaged_edge);
    EXPECT_NEAR(x_C.x(), bit::tip_C(c).x(), plane) << c.id;
    EXPECT_LT(x_C.z(), 0.0) << c.id;
    EXPECT_LE(far, arc) << c.id;
    EXPECT_GE(far, arc - 0.5 * of_sides * c.diameter) << c.id;
    ++engaged;
  }
  EXPECT_EQ(engaged, 28);
}

/// What a history records of a section is where the forces of face and chamfer act.
TEST(Cuts, act_where_sections_and_engaged_edges_have_their_centroids) {
  const Simulation& s = drilling_bit_b();
  for (const CutOfPart& c : s.work.cuts) {
    const bit::Part& part = bit_b().parts[at(c.part)];
    if (part.kind != bit::PartKind::face && part.kind != bit::PartKind::chamfer) continue;
    const rock::Section& section = s.work.measures.sections[at(part.cutter)];
    const Vec3 x_B =
        part.kind == bit::PartKind::face ? section.centroid_B : section.edge_centroid_B;
    EXPECT_EQ(s.work.loads.parts[at(c.part)].point_W, Vec3(s.state.place.X_WB * x_B)) << part.name;
  }
}

/// Sides of a pad that only slide have an area whose vectors cancel, or no ramp to press with: they bear
/// nothing, and the contact below them bears once.
TEST(Cuts, count_the_contact_below_once_where_sides_bear_nothing) {
  const Case c =
      read_case(TDBD_SOURCE_DIR "/cases/drill-bit-b-whirl-rock.toml", {"rock.edge_length='6 mm'"});
  const auto pad = static_cast<std::size_t>(
      std::ranges::find(c.bit.parts, bit::PartKind::gage_pad, &bit::Part::kind) -
      c.bit.parts.begin());
  ASSERT_LT(pad, c.bit.parts.size());
  const rock::CuttingBit cutting;
  const rock::CutWorkspace cut_work;
  rock::CutReport cut;
  cut.removed_by_part.assign(c.bit.parts.size(), 0.0);
  const Move move;
  const FacePaths paths;
  const MeasuredStep measured{c.bit, cutting, cut_work, cut, move, c.rock.edge_length, 0, paths};
  Measures m;
  m.contacts.resize(c.bit.parts.size());
  m.sections.resize(c.bit.cutters.size());
  m.removed.resize(c.bit.cutters.size());
  constexpr double below = 3e-6;  // m2
  m.contacts[pad].below = {below, Vec3(0.0, -below, 0.0), Vec3(0.0, 0.1, 0.0)};
  m.contacts[pad].sides = {2e-6, Vec3::Zero(), Vec3(0.0, 0.1, 0.0)};
  std::vector<CutOfPart> cuts;
  gather_cuts(c.forces, measured, m, cuts);
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_EQ(cuts[0].part, static_cast<int>(pad));
  EXPECT_EQ(cuts[0].cut.contact_area, below);
}

}  // namespace tdbd::simulation::cuts_test
