#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/small_case.hpp"

/// A coefficient without effect produces a warning, and the run continues.
namespace tdbd::app::case_warning_test {

const std::string idle = "forces.A7: acts on no part of small (it has no cse); leave it out";

/// The small case with forces whose law has a coefficient for cse, which the bit has not; more
/// lines follow those of [forces].
SmallCase with_A7(const std::string& more = "") {
  SmallCase c;
  c.edit("case.toml", "wall = \"20 mm\"", "wall = \"20 mm\"\nmaterial = \"mancos-shale\"");
  c.edit("case.toml", "duration = \"40 ms\"",
         "duration = \"40 ms\"\n[forces]\nlaw = \"hanson-hansen\"\nA1 = 1\nA3 = 0.3\nA7 = 0.5\n" +
             more);
  return c;
}

std::string warning(const SmallCase& c, const std::string& text, int line) {
  return "tdbd: warning: " + c.path("case.toml").string() + ":" + std::to_string(line) + ": " +
         text + "\n";
}

nlohmann::json summary(const SmallCase& c, const std::string& out) {
  return nlohmann::json::parse(read(c.path(out + "/summary.json")));
}

TEST(CaseWarning, reports_a_coefficient_that_acts_on_no_part) {
  const SmallCase c = with_A7();
  const auto o = c.check();
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.err, warning(c, idle, 17));
}

TEST(CaseWarning, of_a_run_is_printed_before_its_progress_and_stored_in_its_summary) {
  const SmallCase c = with_A7();
  const auto o = c.run();
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_TRUE(o.err.starts_with(warning(c, idle, 17))) << o.err;
  EXPECT_EQ(summary(c, "out").at("warnings"), nlohmann::json::array({idle}));
}

TEST(CaseWarning, is_printed_with_quiet) {
  const SmallCase c = with_A7();
  const auto o = c.run({"--quiet"});
  EXPECT_EQ(o.err, warning(c, idle, 17));
  EXPECT_EQ(o.out, "");
  EXPECT_TRUE(summary(c, "out").contains("warnings"));
}

const std::string no_strength =
    ": has no effect: the law detournay does not depend on the strength of the rock; change its "
    "coefficients, or use hanson-hansen, thin-cut (faces) or indentation (teeth)\n";

/// A rock that is only named is the label of the coefficients.
TEST(CaseWarning, reports_a_strength_that_the_law_ignores) {
  const SmallCaseWithForces c("");
  EXPECT_EQ(c.check().err, "");
  EXPECT_EQ(c.check({"--set", "rock.material=mancos-shale"}).err,
            "tdbd: warning: --set: rock.material" + no_strength);
  EXPECT_EQ(c.check({"--set", "forces={law='hanson-hansen', A1=1, A3=0.3}", "--set",
                     "rock.material=mancos-shale"})
                .err,
            "");
  c.edit("case.toml", "material = \"berea-sandstone\"",
         "material = {unconfined_strength = \"60 MPa\", friction_angle = \"30 deg\"}");
  EXPECT_EQ(c.check().err, "tdbd: warning: " + c.path("case.toml").string() +
                               ":6: rock.material.unconfined_strength" + no_strength);
}

TEST(CaseWarning, names_an_override_as_such) {
  const SmallCase c = with_A7();
  c.edit("case.toml", "A7 = 0.5\n", "");
  EXPECT_EQ(c.check({"--set", "forces.A7=1"}).err, "tdbd: warning: --set: " + idle + "\n");
}

/// A kind of part that has a table of its own does not feel the run's coefficients.
TEST(CaseWarning, reports_coefficients_of_kinds_that_follow_another_law) {
  const SmallCase c = with_A7(
      "A8 = 0.1\n[forces.cse]\nlaw = \"none\"\n[forces.gage_pad]\n"
      "law = \"friction\"\nstress = 1e6\nmu = 0.3\ncap = 2\n");
  const std::string leave = "; leave it out";
  const std::string other = ": acts on no part of small (another law for cse, cutter body)" + leave;
  EXPECT_EQ(
      c.check().err,
      warning(c, "forces.A7" + other, 17) + warning(c, "forces.A8" + other, 18) +
          warning(c, "forces.gage_pad.cap: acts on no part of small (it has no gage pad)" + leave,
                  25));
}

/// Coefficients that act, defaults and required coefficients produce no warning.
TEST(CaseWarning, is_rare) {
  const SmallCase c = with_A7(
      "[forces.cutter_body]\nlaw = \"hanson-hansen\"\nA1 = 2\nA3 = 0.2\n"
      "A7 = 0.5\nA8 = 0.5\n");
  c.edit("case.toml", "A7 = 0.5\n[", "A7 = 0\nA4 = 0.5\n[");
  EXPECT_EQ(c.check().err, "");
  EXPECT_EQ(c.run({"--quiet"}).exit_code, 0);
  EXPECT_FALSE(summary(c, "out").contains("warnings"));
}

TEST(CaseWarning, reports_edges_that_resolve_no_cutter) {
  const SmallCase c;
  EXPECT_EQ(c.check({"--set", "rock.edge_length=8 mm"}).err, "");
  const auto o = c.check({"--set", "rock.edge_length=9 mm"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.err,
            "tdbd: warning: --set: rock.edge_length: edges of 9 mm do not resolve the cuts of a "
            "part 16 mm wide; for meaningful volumes and forces use at most half of that\n");
}

/// Above the rock or beside it: before the run by its way, and at its end by what it removed.
TEST(CaseWarning, reports_a_bit_that_never_reaches_the_rock) {
  for (const std::string start : {"[0, 0, -100]", "[10, 0, 0]"}) {
    const SmallCase c;
    c.edit("case.toml", "rotary_speed", "start = " + start + "\nrotary_speed");
    const std::string distance = start == "[10, 0, 0]" ? "9.86 m" : "99.9 m";
    const std::string place = "tdbd: warning: " + c.path("case.toml").string() + ":6: motion: ";
    const std::string before =
        place + "the bit stays " + distance + " or more from the rock and cuts nothing\n";
    EXPECT_EQ(c.check().err, before);
    const auto o = c.run();
    EXPECT_EQ(o.exit_code, 0);
    EXPECT_TRUE(o.err.starts_with(before)) << o.err;
    const std::string at_end =
        "the bit removed no rock in 20 steps: it stays " + distance + " or more from it";
    EXPECT_TRUE(o.err.ends_with(place + at_end + "\n")) << o.err;
    EXPECT_EQ(summary(c, "out").at("warnings"), nlohmann::json::array({"motion: " + at_end}));
  }
}

/// A centimetre above its hole, too near for a warning at the start.
TEST(CaseWarning, reports_the_position_of_a_bit_that_removes_nothing) {
  const SmallCase c;
  const auto o = c.run({"--set", "motion.start=[0, 0, -0.01]"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_TRUE(o.err.ends_with(":6: motion: the bit removed no rock in 20 steps\n")) << o.err;
}

/// The resolved case lists every setting and produces the same warnings as the case.
TEST(CaseWarning, of_the_resolved_case_is_the_same) {
  const SmallCase c = with_A7();
  ASSERT_EQ(c.run({"--quiet"}).exit_code, 0);
  const auto again = battery::run_tdbd(
      {"run", c.path("out/case.toml").string(), "-o", c.path("again").string(), "--quiet"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(summary(c, "again").at("warnings"), summary(c, "out").at("warnings"));
}

}  // namespace tdbd::app::case_warning_test
