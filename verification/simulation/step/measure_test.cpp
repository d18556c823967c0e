#include "simulation/step/measure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rotation/screw.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::measure_test {
namespace {

Case steady_case(int section_every) {
  return read_case(
      TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml",
      {"rock.edge_length='4 mm'", fmt::format("measure.section_every={}", section_every)});
}

/// The same face, and bitwise the same number; NaN is equal to NaN.
bool is_same(const rock::Section& a, const rock::Section& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return same(a.area, b.area) && same(a.engaged_edge, b.engaged_edge) &&
         same(a.volume_rate, b.volume_rate) && same(a.centroid_B.x(), b.centroid_B.x());
}

}  // namespace

/// Bit B has faces, chamfers, cutter bodies and gage pads; the law acts on all but the pads.
TEST(ContactsOf, are_by_whole_triangles_where_a_section_gives_the_force) {
  using rock::ContactRule;
  for (const auto& [settings, of_chamfers] :
       {std::pair{std::vector<std::string>{}, ContactRule::whole_triangles},
        {{"forces.chamfer_contact='triangles'"}, ContactRule::clipped}}) {
    const Case c = read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml", settings);
    const auto contacts = contacts_of(c.bit, c.forces);
    ASSERT_EQ(contacts.size(), c.bit.parts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const bit::PartKind kind = c.bit.parts[i].kind;
      const ContactRule expected = kind == bit::PartKind::face      ? ContactRule::whole_triangles
                                   : kind == bit::PartKind::chamfer ? of_chamfers
                                                                    : ContactRule::clipped;
      EXPECT_EQ(contacts[i].rule, expected) << c.bit.parts[i].name;
      EXPECT_EQ(contacts[i].ramp > 0.0,
                kind == bit::PartKind::cutter_body || kind == bit::PartKind::gage_pad)
          << c.bit.parts[i].name;
    }
  }
}

/// The motion is prescribed, so that both runs cut the same rock.
TEST(SectionsInTurn, are_those_of_every_step_in_a_faces_turn_and_stay_in_between) {
  constexpr long every = 3;
  const Case each = steady_case(1), in_turn = steady_case(every);
  Simulation a = start(each), b = start(in_turn);
  for (long k = 0; k < 40; ++k) {
    const std::vector<rock::Section> last = b.work.measures.sections;
    step(each, a);
    step(in_turn, b);
    for (std::size_t i = 0; i < last.size(); ++i) {
      const bool is_due = (k + static_cast<long>(i)) % every == 0;
      const rock::Section& now = b.work.measures.sections[i];
      EXPECT_TRUE(is_same(now, is_due ? a.work.measures.sections[i] : last[i])) << k << ' ' << i;
      EXPECT_EQ(b.work.measures.is_new[i] != 0, is_due);
    }
    if (k == 0) {
      EXPECT_TRUE(std::ranges::equal(a.work.measures.sections, b.work.measures.sections, is_same));
    }
  }
}

/// What is removed counts in every step.
TEST(SectionsInTurn, count_once_each) {
  const Case c = steady_case(4);
  Simulation s = start(c);
  for (int k = 0; k < 41; ++k) step(c, s);
  const FaceStatistics& faces = s.statistics.faces;
  ASSERT_EQ(faces.refused_deep + faces.refused_over_the_top, 0);
  for (std::size_t i = 0; i < faces.revolution.size(); ++i) {
    const FaceVariances& spreads = faces.revolution[i];
    EXPECT_EQ(spreads.area.count, 11) << i;  // in the first step, and ten times in its turn
    EXPECT_EQ(spreads.swept.count, spreads.area.count);
    EXPECT_EQ(spreads.removed.count, 41);
  }
}

/// The bit a quarter of a metre down in rock that it has not opened, turning: no face sees the
/// rock's surface. `share`: of what its face sweeps, what each cutter is said to have removed.
Measures measured_deep_in_rock(const Case& c, double share) {
  Simulation s = start(c);
  constexpr double dt = 1e-3, w = 12.0;  // s, rad/s
  const Pose deep{Mat3::Identity(), Vec3(0.0, 0.0, 0.25)};
  const Move move{deep, deep * rotation::carried({w * Vec3::UnitZ(), Vec3::Zero()}, dt), dt, w * dt,
                  0};
  rock::CutReport cut;
  cut.removed_by_part.assign(c.bit.parts.size(), 0.0);
  for (std::size_t i = 0; i < c.bit.parts.size(); ++i) {
    const bit::Part& part = c.bit.parts[i];
    if (part.kind != bit::PartKind::face) continue;
    const bit::Cutter& cutter = c.bit.cutters[at(part.cutter)];
    const double ahead = cutter.X_BC.R.col(0).dot(w * Vec3::UnitZ().cross(cutter.X_BC.p));
    const double area = 0.25 * std::numbers::pi * cutter.diameter * cutter.diameter;
    cut.removed_by_part[i] = share * area * ahead * dt;
  }
  MeasurePlan plan = c.measure;
  plan.contact = ContactMeasure::off;
  MeasureWork work;
  Measures m;
  measure_cut(s.state.rock, plan, s.work.faces,
              {c.bit, s.work.cutting, s.work.cut_work, cut, move, c.rock.edge_length, 0, {}}, work,
              m);
  return m;
}

/// A face out of sight of the rock's surface is in the open, or deep in rock: then it removes more
/// than half of what it sweeps. Some of that is worn away: a share of 0.8 is enough, 0.3 is not.
TEST(SectionsDeepInRock, are_rejected_where_a_face_removes_what_it_sweeps) {
  const Case c = steady_case(1);
  const Measures deep = measured_deep_in_rock(c, 0.8), open = measured_deep_in_rock(c, 0.3);
  ASSERT_EQ(deep.sections.size(), c.bit.cutters.size());
  for (std::size_t i = 0; i < deep.sections.size(); ++i) {
    if (c.bit.cutters[i].X_BC.p.head<2>().norm() < 0.02) continue;  // across the axis
    EXPECT_EQ(deep.sections[i].sight, rock::OutlineStatus::none) << i;
    EXPECT_TRUE(std::isnan(deep.sections[i].area)) << i;
    EXPECT_EQ(open.sections[i].area, 0.0) << i;
  }
}

/// A section that cannot be computed is rejected once and does not count until the next one.
TEST(SectionsInTurn, are_rejected_once_each) {
  FaceStatistics statistics;
  statistics.revolution.resize(1);
  Measures m;
  m.sections.resize(1);
  m.removed = {1e-9};
  m.is_new = {1};
  m.sections[0].area = NAN;
  m.sections[0].sight = rock::OutlineStatus::none;
  Move move;
  add(move, m, statistics);
  m.is_new = {0};
  add(move, m, statistics);
  add(move, m, statistics);
  EXPECT_EQ(statistics.refused_deep, 1);
  EXPECT_EQ(statistics.revolution[0].removed.count, 0);
}

}  // namespace tdbd::simulation::measure_test
