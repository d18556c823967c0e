#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "simulation/case/case.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// Parts that rub: they remove no rock, and their law acts on the rock that is inside them.
namespace tdbd::simulation::rubbing_test {

/// Two flat blocks of 30 mm x 2 mm and 10 mm x 8 mm at a radius of 80 mm: the first cuts; the second is
/// 0.5 mm higher and a sixth of a revolution ahead. The bit advances 3 mm in a revolution.
std::string rubbing_case(const std::string& second, const std::string& forces) {
  const auto folder = test_folder();
  mesh::write_mesh(folder / "a.off", battery::box({65, -2, -20}, {95, 0, 0}));
  mesh::write_mesh(folder / "b.off", battery::box({75, -4, -20}, {85, 4, 0}));
  const std::string bit_file = write_file(
      folder / "bit.toml",
      "name = \"two\"\n[[parts]]\nname = \"cutter\"\nkind = \"gage-pad\"\nfile = \"a.off\"\n"
      "update_direction = [0, 0, 1]\n[[parts]]\nname = \"tooth\"\nkind = \"cse\"\n"
      "file = \"b.off\"\nposition = [0, 0, \"-0.5 mm\"]\n"
      "rotation_vector = [0, 0, \"60 deg\"]\nupdate_direction = [0, 0, 1]\n" +
          second);
  return write_file(folder / "case.toml",
                    "[bit]\nfile = \"" + bit_file +
                        "\"\n[rock]\nshape = \"flat\"\nradius = \"110 mm\"\nwall = \"5 mm\"\n"
                        "edge_length = \"2 mm\"\n" +
                        (forces.empty() ? "" : "material = \"mancos-shale\"\n") +
                        "[motion]\n"
                        "rotary_speed = \"60 rpm\"\nrate_of_penetration = \"3 mm/s\"\n[time]\n"
                        "step = \"2 ms\"\nduration = \"0.6 s\"\n" +
                        forces);
}

const std::string rubs = "cutting = false\nrubs = true\n";
const std::string flat_law =
    "[forces]\nlaw = \"friction\"\nstress = \"10 MPa\"\nmu = 0.5\nfull_angle = 0\n";

Simulation ended(const Case& c) {
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  return s;
}

/// After 0.6 s the part is 1.3 mm deep in rock that the other, six tenths of a revolution on its way,
/// has not cut yet: it bears with its whole base of 80 mm2.
TEST(PartsThatRub, bear_load_and_remove_no_rock) {
  const Case c = read_case(rubbing_case(rubs, flat_law), {});
  const Simulation s = ended(c);
  EXPECT_EQ(s.state.ledger.removed_by_part[1].value(), 0.0);
  EXPECT_GT(s.state.ledger.removed_by_part[0].value(), 0.0);
  const PartLoad& load = s.work.loads.parts.at(1);
  EXPECT_NEAR(s.work.measures.contacts[1].below.area, 80e-6, 1e-9);
  EXPECT_NEAR(-load.force_W.z(), 800.0, 0.5);
  EXPECT_NEAR(load.tangential, 400.0, 0.5);
}

/// Without a law it neither bears nor is its contact measured.
TEST(PartsThatRub, are_not_measured_without_a_law) {
  const Case c = read_case(rubbing_case(rubs, flat_law + "[forces.cse]\nlaw = \"none\"\n"), {});
  const Simulation s = ended(c);
  EXPECT_TRUE(s.work.rubbing.empty());
  EXPECT_EQ(s.work.measures.contacts[1].below.area, 0.0);
  EXPECT_TRUE(
      ended(read_case(rubbing_case("cutting = false\n", flat_law), {})).work.rubbing.empty());
}

std::vector<std::string> warnings(const Case& c) {
  std::vector<std::string> texts;
  for (const CaseWarning& w : end_warnings(c, ended(c))) texts.push_back(w.text);
  return texts;
}

TEST(PartsThatRub, produce_a_warning_without_a_law) {
  const auto texts = [](const std::string& second, const std::string& forces) {
    std::vector<std::string> found;
    for (const CaseWarning& w : read_case(rubbing_case(second, forces), {}).warnings)
      found.push_back(w.text);
    return found;
  };
  const std::string without = flat_law + "[forces.cse]\nlaw = \"none\"\n";
  EXPECT_EQ(texts(rubs, without),
            std::vector<std::string>{
                "tooth rubs, but no force acts on it: no law is given for a cse; set "
                "forces.cse.law, or rubs = false"});
  EXPECT_EQ(texts(rubs, flat_law), std::vector<std::string>{});
  EXPECT_EQ(texts("cutting = false\n", without), std::vector<std::string>{});
}

/// Deeper than an edge of 1 mm and than 1 mm; not while it is less deep.
TEST(PartsThatRub, produce_a_warning_when_deep_in_rock) {
  const std::vector<std::string> fine{"rock.edge_length='1 mm'"};
  EXPECT_EQ(
      warnings(read_case(rubbing_case(rubs, flat_law), fine)),
      std::vector<std::string>{"tooth is 1.3 mm deep in rock at the end of the run, after 0.6 s: "
                               "it removes no rock"});
  EXPECT_EQ(
      warnings(read_case(rubbing_case(rubs, ""), fine)),
      std::vector<std::string>{"tooth is 1.3 mm deep in rock at the end of the run, after 0.6 s: "
                               "it removes no rock, and no force acts on it"});
  EXPECT_EQ(warnings(read_case(rubbing_case(rubs, flat_law), {})), std::vector<std::string>{});
  EXPECT_EQ(warnings(read_case(rubbing_case("cutting = false\n", flat_law), fine)),
            std::vector<std::string>{})
      << "a cse that neither cuts nor rubs is not there";
}

/// Of the two blocks the cutter, a gage pad, removes all rock. Its law decides whether for a force.
TEST(PartsThatCut, produce_a_warning_at_zero_force) {
  const std::string free = flat_law + "[forces.gage_pad]\nlaw = \"none\"\n";
  const Case c = read_case(rubbing_case(rubs, free), {});
  const std::vector<CaseWarning> found = end_warnings(c, ended(c));
  ASSERT_EQ(found.size(), 1u);
  const Simulation s = ended(c);
  EXPECT_EQ(
      found[0].text,
      fmt::format("parts of the kind gage-pad removed {:.3g} mm3 of rock, 100 % of all, at zero "
                  "force: set forces.gage_pad.law",
                  1e9 * s.state.ledger.removed.value()));
  EXPECT_EQ(warnings(read_case(rubbing_case(rubs, flat_law), {})), std::vector<std::string>{});
  EXPECT_EQ(warnings(read_case(rubbing_case(rubs, ""), {})), std::vector<std::string>{})
      << "without [forces] nothing has a force";
}

/// A flat cutter and, `lag` (rad) behind it and `under` (m) less exposed, a pad that rubs. Their rear
/// edges lie on radii, so that lag is that of every point of them.
Case follower_case(double lag, double under, double advance) {
  const auto folder = test_folder();
  mesh::write_mesh(folder / "cutter.off", battery::box({65, 0, -20}, {95, 3, 0}));
  mesh::write_mesh(folder / "pad.off", battery::box({75, 0, -20}, {85, 8, 0}));
  const std::string bit_file = write_file(
      folder / "bit.toml",
      fmt::format("name = \"follower\"\n[[parts]]\nname = \"cutter\"\nkind = \"gage-pad\"\n"
                  "file = \"cutter.off\"\nupdate_direction = [0, 0, 1]\n"
                  "[[parts]]\nname = \"ovoid\"\nkind = \"bit-body\"\nfile = \"pad.off\"\n"
                  "cutting = false\nrubs = true\nposition = [0, 0, {}]\n"
                  "rotation_vector = [0, 0, {}]\n",
                  -under, -lag));
  return read_case(
      write_file(folder / "case.toml",
                 fmt::format("[bit]\nfile = \"{}\"\n[rock]\nshape = \"flat\"\n"
                             "radius = \"110 mm\"\nwall = \"5 mm\"\nedge_length = \"2 mm\"\n"
                             "material = \"mancos-shale\"\n[motion]\nrotary_speed = \"60 rpm\"\n"
                             "rate_of_penetration = {}\n[time]\nstep = \"2 ms\"\n"
                             "duration = \"0.7 s\"\n[forces]\nlaw = \"friction\"\n"
                             "stress = \"10 MPa\"\nmu = 0.5\n",
                             bit_file, advance)),
      {});
}

/// Depth of cut control: the pad touches at 2 pi under/lag per revolution, exact to a thousandth of
/// `under`: not when the bit advances a thousandth less, and when it advances a thousandth more.
TEST(DepthOfCutControl, begins_where_the_bit_sinks_by_the_under_exposure_between_cutter_and_pad) {
  constexpr double onset_error = 1e-3;
  for (const auto& [lag, under] : {std::pair{1.0, 0.5e-3}, {0.5, 0.2e-3}, {1.7, 1.1e-3}}) {
    const double onset = 2.0 * std::numbers::pi * under / lag;  // m per revolution, at 1 a second
    const auto area = [&](double share) {
      return ended(follower_case(lag, under, share * onset)).work.measures.contacts[1].below.area;
    };
    EXPECT_EQ(area(1.0 - onset_error), 0.0) << lag;
    EXPECT_GT(area(1.0 + onset_error), 0.0) << lag;
    const double strip = 10e-3 * 80e-3 * lag * 0.05;  // m2: the rear twentieth of the lag
    EXPECT_NEAR(area(1.0 / 0.95), strip, 0.01 * strip) << lag;
  }
}

/// Bit B drills 12 mm a revolution, so that its body touches the rock. The contact that a run finds is
/// the same as that of a freshly prepared body, for which no earlier step has shown where it is clear.
/// There is no maintenance, after which a run would search all rock again.
TEST(PartsThatRub, have_results_independent_of_the_time_without_contact) {
  const Case c = read_case(
      write_file(
          test_folder() / "b.toml",
          "[bit]\nfile = \"" TDBD_SOURCE_DIR
          "/cases/bits/bit-b.toml\"\n[rock]\nshape = \"conforming\"\nwall = \"30 mm\"\n"
          "edge_length = \"3 mm\"\nmaterial = \"mancos-shale\"\n[motion]\n"
          "rotary_speed = \"120 rpm\"\nrate_of_penetration = \"24 mm/s\"\n[time]\n"
          "step = \"2 ms\"\nrevolutions = 0.8\n[forces]\nlaw = \"hanson-hansen\"\nA1 = 1\n"
          "A2 = 0.3\nA3 = \"18 deg\"\nA4 = 0.5\nA5 = 1\nA6 = 0.3\n[maintenance]\nevery = 0\n"),
      {});
  constexpr long every = 7;
  Simulation s = start(c);
  int clear = 0, touching = 0;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    if (s.state.steps_done % every != 0) continue;
    const rock::RubbingPart& kept = s.work.rubbing.at(0);
    rock::RubbingPart fresh =
        rock::prepare_rubbing_part(c.bit.parts.at(at(kept.part)), 0, s.state.rock.grid.cell());
    rock::RubbingWork work;
    const double area = rock::rubbing_contact(s.state.rock, fresh, over_rock(s.state.place),
                                              s.work.limits.longest_edge, {}, work)
                            .area;
    EXPECT_EQ(s.work.measures.contacts[at(kept.part)].below.area, area);
    clear += kept.clear.changes >= 0 ? 1 : 0;
    touching += area > 0.0 ? 1 : 0;
  }
  EXPECT_GT(clear, 2);
  EXPECT_GT(touching, 2);
}

}  // namespace tdbd::simulation::rubbing_test
