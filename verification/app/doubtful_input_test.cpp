#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/rotate_folder.hpp"
#include "app/small_case.hpp"

/// What files of other programs and numbers without a unit bring: the message or the value.
namespace tdbd::app::doubtful_input_test {

std::string warning(const std::string& text) { return "tdbd: warning: " + text + "\n"; }

struct BareNumber {
  const char* setting;
  const char* doubt;  ///< empty: none
};

/// A number that is unusual in SI and usual in the unit of the field.
TEST(BareNumber, is_doubted_if_it_is_usual_in_another_unit_only) {
  const SmallCaseWithForces c("");
  for (const BareNumber& b : std::vector<BareNumber>{
           {"motion.rate_of_penetration=15",
            "15 without a unit is 15 m/s; did you mean \"15 m/h\" or \"15 ft/h\" or \"15 mm/s\"?"},
           {"motion.rate_of_penetration=0.004", ""},
           {"motion.rotary_speed=120",
            "120 without a unit is 120 rad/s; did you mean \"120 rpm\" or \"120 deg/s\"?"},
           {"motion.rotary_speed=12.5", ""},
           {"rock.pressure=3000",
            "3000 without a unit is 3000 Pa; did you mean \"3000 psi\" or "
            "\"3000 bar\" or \"3000 MPa\"?"},
           {"rock.pressure=0", ""},
           {"rock.pressure=2e7", ""},
           {"rock.wall=20", "20 without a unit is 20 m; did you mean \"20 mm\" or \"20 in\"?"},
           {"rock.wall=0.02", ""},
           {"rock.dip_azimuth=45", "45 without a unit is 45 rad; did you mean \"45 deg\"?"}}) {
    const std::string setting = b.setting, key = setting.substr(0, setting.find('='));
    const auto o = c.check({"--set", "time.step=0.1 ms", "--set", setting});
    const std::string doubt = b.doubt;
    EXPECT_EQ(o.err.find("without a unit is") != std::string::npos, !doubt.empty()) << o.err;
    if (!doubt.empty()) {
      EXPECT_NE(o.err.find(key + ": " + doubt), std::string::npos) << setting << o.err;
    }
  }
}

TEST(BareNumber, is_doubted_at_its_line_in_a_file_and_not_in_the_summary) {
  const SmallCase c;
  c.edit("case.toml", "rotary_speed = \"120 rpm\"", "rotary_speed = 120");
  c.edit("case.toml", "step = \"2 ms\"\nduration = \"40 ms\"",
         "step = \"1 ms\"\nduration = \"20 ms\"");
  const std::string doubt =
      "motion.rotary_speed: 120 without a unit is 120 rad/s; did you mean \"120 rpm\" or \"120 "
      "deg/s\"?";
  const auto o = c.run({"--quiet"});
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(o.err.starts_with(warning(c.path("case.toml").string() + ":7: " + doubt))) << o.err;
  const auto summary = nlohmann::json::parse(read(c.path("out/summary.json")));
  EXPECT_FALSE(summary.contains("warnings")) << summary["warnings"];  // a resolved case has none
}

/// A zone in Latin-1 passed `check`, and ended `run` with half a folder.
TEST(TextThatIsNotUtf8, is_rejected_with_its_line_and_byte) {
  const SmallCase c;
  c.edit("bit.csv", "S,2,2,cone", "S,2,2,c\xF4ne");
  expect_refused(c,
                 "bit.csv:3: byte 8 of the line: found 0xF4, expected text in UTF-8: save the "
                 "sheet as \"CSV UTF-8\"");
  const SmallCase d;
  d.edit("bit.toml", "name = \"small\"", "name = \"sm\xE5ll\"");
  expect_refused(d, "bit.toml:1: byte 11 of the line: found 0xE5, expected text in UTF-8");
  const auto o = d.check({"--set", "title=caf\xE9"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err,
            "tdbd: command line: word 4: found byte 0xE9 after \"title=caf\", expected UTF-8: "
            "rename the file\n");
}

TEST(Means, that_begin_at_the_end_of_the_run_are_doubted) {
  const SmallCase c;
  const auto told = [&](const char* from) {
    return c.check({"--set", std::string("output.means_from=") + from}).err;
  };
  const std::string doubt =
      "s and the run ends at 0.04 s: all means will have no value (null); use less than 0.04 s, "
      "or a longer run";
  EXPECT_EQ(told("40 ms"), warning("--set: output.means_from: means begin at 0.04 " + doubt));
  EXPECT_EQ(told("1 s"), warning("--set: output.means_from: means begin at 1 " + doubt));
  EXPECT_EQ(told("38 ms"), "");
}

TEST(Rate, that_is_negative_is_doubted) {
  const SmallCase c;
  EXPECT_EQ(
      c.check({"--set", "motion.rate_of_penetration=-15 m/h"}).err,
      warning("--set: motion.rate_of_penetration: a negative rate moves the bit up, away from "
              "the bottom of the hole"));
}

/// A plate 9 km away: no edge length helps, so the message does not propose one.
TEST(RockFarAway, is_rejected_with_both_places) {
  const SmallCase c;
  std::string off = "OFF\n441 800 0\n";
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j)
      off += std::to_string(5850000 + 4 * i) + " " + std::to_string(6925000 + 4 * j) + " 758000\n";
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const int a = 21 * i + j;
      off += "3 " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 21) +
             "\n3 " + std::to_string(a + 1) + " " + std::to_string(a + 22) + " " +
             std::to_string(a + 21) + "\n";
    }
  c.write("far.off", off);
  c.edit("case.toml", "wall = \"20 mm\"", "shape = \"file\"\nfile = \"far.off\"\nunit = \"1 mm\"");
  const auto o = c.check();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("case.toml:6: rock.file: found rock 9097 m from the bit: its middle is at "
                       "(5850, 6925, 758) m"),
            std::string::npos)
      << o.err;
  EXPECT_EQ(o.err.find("edge_length"), std::string::npos) << o.err;
}

/// 5 rad in a step: the energy of a free body changes by most of its scale.
TEST(LongStepOfRotation, is_reported_by_the_drift_of_the_energy) {
  const RotateFolder c;
  c.write("case.toml",
          "[body]\ninertia = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]\n"
          "angular_velocity = [0.01, 5, 0.01]\n[time]\nstep = \"1 s\"\nduration = \"100 s\"\n");
  const auto o = c.rotate({"--quiet"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_NE(o.err.find("the energy of this conservative motion has changed by 85 % of its scale"),
            std::string::npos)
      << o.err;
  EXPECT_NE(o.err.find("the body turns by 5 rad in a step"), std::string::npos) << o.err;
  EXPECT_EQ(nlohmann::json::parse(read(c.path("out/summary.json"))).at("warnings").size(), 2u);
  EXPECT_EQ(c.rotate({"--quiet", "--set", "time.step=10 ms"}, "fine").err, "");
}

/// A body that is turned faster and faster passes the limit only later.
TEST(LongStepOfRotation, is_reported_by_the_largest_turn) {
  const RotateFolder c;
  c.write("case.toml",
          "[body]\ninertia = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]\n"
          "[load]\nbody_torque = [0, 0, 3]\n[time]\nstep = \"0.1 s\"\nduration = \"10 s\"\n");
  EXPECT_EQ(c.rotate({"--quiet"}).err,
            warning(c.path("case.toml").string() +
                    ":6: time.step: the body has turned by up to 1 rad in a step of 0.1 s; for "
                    "meaningful results use at most 0.5 rad: 0.05 s"));
  EXPECT_EQ(c.rotate({"--quiet", "--set", "time.step=40 ms"}, "fine").err, "");
}

}  // namespace tdbd::app::doubtful_input_test
