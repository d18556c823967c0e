#include <gtest/gtest.h>

#include "app/case_folder.hpp"
#include "app/mistake.hpp"

namespace tdbd::app::bad_string_test {

constexpr const char* case_text = R"(title = "a well"
[string]
model = "chain"
element_length = "20 m"
[[string.sections]]
length = "900 m"
outer_diameter = "127 mm"
inner_diameter = "108.6 mm"
contact_diameter = "168.2 mm"
[string.survey]
measured_depth = ["0 m", "300 m", "900 m"]
inclination = ["0 deg", "0 deg", "60 deg"]
azimuth = ["0 deg", "0 deg", "30 deg"]
[string.friction]
static = 0.3
dynamic = 0.2
[string.top]
torsion = "pi"
inertia = "2900 kg m2"
proportional = "3e3 N m s/rad"
integral = "6e3 N m/rad"
[motion]
rotary_speed = "60 rpm"
[time]
step = "2 ms"
duration = "20 ms"
[output]
string_depths = ["0 m", "900 m"]
)";

class StringFolder : public CaseFolder {
 public:
  StringFolder() { write("case.toml", case_text); }
  battery::Outcome run(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"string", path("case.toml").string(), "-o",
                                   path("out").string()};
    words.insert(words.end(), more.begin(), more.end());
    return battery::run_tdbd(words);
  }
};

class BadString : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadString, is_rejected_with_its_place_and_reason) {
  const Mistake& m = GetParam();
  const StringFolder c;
  c.edit("case.toml", m.from, m.to);
  expect_refusal(c.run(), c.path("case.toml").string() + ":" + m.message);
  expect_refusal(c.check(), c.path("case.toml").string() + ":" + m.message);
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
}

const Mistake mistakes[] = {
    {"no_section",
     "[[string.sections]]\nlength = \"900 m\"\nouter_diameter = \"127 mm\"\ninner_diameter = "
     "\"108.6 mm\"\ncontact_diameter = \"168.2 mm\"\n",
     "", "2: string.sections: found no section, expected at least one [[string.sections]]"},
    {"inner_not_below_outer", "108.6 mm", "127 mm",
     "8: string.sections[0].inner_diameter: found 0.127 m, expected less than the outer diameter, "
     "0.127 m"},
    {"contact_below_outer", "168.2 mm", "100 mm",
     "9: string.sections[0].contact_diameter: found 0.1 m, expected at least the outer diameter, "
     "0.127 m"},
    {"length_of_zero", "\"900 m\"\nouter", "\"0 m\"\nouter",
     "6: string.sections[0].length: found \"0 m\", expected length in m, > 0"},
    {"length_that_is_no_number", "\"900 m\"\nouter", "nan\nouter",
     "6: string.sections[0].length: found nan, expected length in m, or a text with a unit"},
    {"length_of_a_wrong_dimension", "\"900 m\"\nouter", "\"900 kg\"\nouter",
     "6: string.sections[0].length: found \"900 kg\" (kg is mass), expected length in m "
     "or "
     "in another unit"},
    {"survey_too_short", "[\"0 m\", \"300 m\", \"900 m\"]", "[\"0 m\", \"300 m\", \"800 m\"]",
     "11: string.survey.measured_depth: found stations down to 800 m for a string of 900 m, "
     "expected a survey that reaches the bit, to 1 %"},
    {"depths_not_ascending", "\"300 m\", \"900 m\"]", "\"900 m\", \"900 m\"]",
     "11: string.survey.measured_depth: found station 3 at 900 m after 900 m: depths ascend, "
     "expected stations of a well"},
    {"survey_not_from_the_surface", "[\"0 m\", \"300 m\", \"900", "[\"10 m\", \"300 m\", \"900",
     "11: string.survey.measured_depth: found station 1 at 10 m: the first station is at 0 m, "
     "expected stations of a well"},
    {"inclination_beyond_the_vertical", "\"60 deg\"]", "\"181 deg\"]",
     "11: string.survey.measured_depth: found station 3 with an inclination of 181 deg: at least "
     "0, "
     "at most 180 deg, expected stations of a well"},
    {"stations_that_point_apart", "\"60 deg\"]", "\"180 deg\"]",
     "11: string.survey.measured_depth: found station 3 points opposite to the one above: the "
     "plane of the "
     "arc is undefined, expected stations of a well"},
    {"too_sharp_a_dogleg", "\"300 m\", \"900 m\"]", "\"850 m\", \"900 m\"]",
     "12: string.survey.inclination: found a dogleg of 36 deg in 30 m above station 3, expected at "
     "most 30 deg in 30 m: check the stations"},
    {"lists_of_different_lengths", "azimuth = [\"0 deg\", ", "azimuth = [",
     "11: string.survey.measured_depth: found 3 depths, 3 inclinations, 2 azimuths: the numbers "
     "must "
     "be equal and at least one, expected stations of a well"},
    {"dynamic_above_static", "dynamic = 0.2", "dynamic = 0.4",
     "16: string.friction.dynamic: found 0.4, expected at most the coefficient at rest, 0.3"},
    {"friction_beyond_two", "static = 0.3", "static = 2.1",
     "15: string.friction.static: found 2.1, expected a plain number, in [0, 2]"},
    {"negative_threshold", "dynamic = 0.2", "threshold = -0.1",
     "16: string.friction.threshold: found -0.1, expected speed in m/s, >= 0"},
    {"step_too_long", "\"2 ms\"", "\"5 ms\"",
     "4: string.element_length: found elements of 20 m with a time step of 0.005 s, expected steps "
     "below 0.00390419 s, or elements of at least 25.8696 m"},
    {"loss_time_too_long", "dynamic = 0.2", "torsional_loss_time = \"20 ms\"",
     "16: string.friction.torsional_loss_time: found a time step of 0.002 s, expected a shorter "
     "loss time, or steps below 0.000966556 s"},
    {"stiffness_of_a_lumped_string", "element_length = \"20 m\"", "axial_stiffness = \"1e6 N/m\"",
     "4: string.axial_stiffness: found a stiffness with model = \"chain\", expected none: it "
     "follows from [[string.sections]]"},
    {"sections_without_the_model", "model = \"chain\"", "model = \"lumped\"",
     "3: string.model: found sections of a string whose model is not \"chain\", expected model = "
     "\"chain\""},
    {"pi_without_inertia", "inertia = \"2900 kg m2\"\n", "",
     "17: string.top.inertia: found nothing, expected moment of inertia in kg m2, > 0 (the key is "
     "required)"},
    {"gain_of_a_tuned_top",
     "torsion = \"pi\"\ninertia = \"2900 kg m2\"\nproportional = \"3e3 N m "
     "s/rad\"\nintegral = \"6e3 N m/rad\"",
     "torsion = \"soft-torque\"\ninertia = \"2900 kg m2\"\nproportional = \"3e3 N m s/rad\"",
     "20: string.top.proportional: found a gain with a tuned top drive, expected impedance_factor, "
     "or torsion = \"pi\""},
    {"frequency_without_soft_torque", "integral = \"6e3 N m/rad\"",
     "integral = \"6e3 N m/rad\"\ntuned_frequency = \"0.2 Hz\"",
     "22: string.top.tuned_frequency: found a frequency without torsion = \"soft-torque\", "
     "expected "
     "none, or that top drive"},
    {"compensation_beyond_its_range",
     "torsion = \"pi\"\ninertia = \"2900 kg m2\"\nproportional = "
     "\"3e3 N m s/rad\"",
     "torsion = \"z-torque\"\ninertia = \"2900 kg m2\"\ncompensation = 0.96",
     "20: string.top.compensation: found 0.96, expected a plain number, in [0, 0.95]"},
    {"top_drive_key_of_a_given_speed",
     "torsion = \"pi\"\ninertia = \"2900 kg m2\"\nproportional = "
     "\"3e3 N m s/rad\"\nintegral = \"6e3 N m/rad\"",
     "torque_limit = \"9 kN m\"",
     "18: string.top.torque_limit: found a key of a top drive with torsion = \"speed\", expected "
     "none, or torsion = \"pi\", \"soft-torque\" or \"z-torque\""},
    {"autodriller_with_a_rate", "integral = \"6e3 N m/rad\"\n[motion]",
     "integral = \"6e3 N m/rad\"\naxial = \"autodriller\"\ngain = 1e-6\nintegral_gain = 2e-7\n"
     "[motion]\nweight_on_bit = \"10 kN\"\nrate_of_penetration = \"1 m/h\"",
     "27: motion.rate_of_penetration: found a rate with axial = \"autodriller\", expected "
     "weight_on_bit alone: the autodriller determines the rate"},
    {"weight_with_a_rate", "[motion]", "[motion]\nweight_on_bit = \"10 kN\"",
     "23: motion.weight_on_bit: found a weight without an autodriller, expected string.top.axial = "
     "\"autodriller\", or rate_of_penetration"},
    {"depth_outside_the_string", "[\"0 m\", \"900 m\"]\n", "[\"0 m\", \"950 m\"]\n",
     "28: output.string_depths: found 950 m, expected depths of the string, 0 to 900 m"},
    {"law_without_its_torque", "[motion]",
     "[string.bit]\nlaw = \"two-level\"\nstatic = 1\n[motion]",
     "22: string.bit.dynamic: found nothing, expected torque in N m, in [0, 1e+16] (the key is "
     "required)"},
    {"key_of_another_law", "[motion]", "[string.bit]\npitch = 1\n[motion]",
     "23: string.bit.pitch: found a key of another law, expected none, or law = \"regenerative\""},
    {"torque_that_grows_in_motion", "[motion]",
     "[string.bit]\nlaw = \"two-level\"\nstatic = 1\ndynamic = 2\n[motion]",
     "25: string.bit.dynamic: found 2 N m, expected at most the torque at rest, 1 N m"},
    {"friction_of_an_axial_string", "element_length = \"20 m\"", "directions = \"axial\"",
     "15: string.friction.static: found friction with directions = \"axial\", expected none, or "
     "directions = \"both\""},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, BadString, ::testing::ValuesIn(mistakes),
                         [](const auto& m) { return std::string(m.param.name); });

/// One mistake in a case with a log of a rig, or in the log.
struct WrongLog {
  const char *name, *file, *from, *to, *message;
};

void PrintTo(const WrongLog& w, std::ostream* out) { *out << w.name; }

constexpr const char* log_text =
    "time [s],RPM [rpm],ROP [m/h],HL [kN]\n0,60,0,200\n0.01,61,1,201\n0.02,62,2,202\n";

class LogFolder : public StringFolder {
 public:
  LogFolder() {
    write("rig.csv", log_text);
    edit("case.toml", "[motion]\nrotary_speed = \"60 rpm\"\n",
         "[string.top.log]\nfile = \"rig.csv\"\nrotary_speed = \"RPM\"\nblock_speed = \"ROP\"\n");
  }
};

class BadLog : public ::testing::TestWithParam<WrongLog> {};

TEST_P(BadLog, is_rejected_with_its_place_and_reason) {
  const WrongLog& w = GetParam();
  const LogFolder c;
  c.edit(w.file, w.from, w.to);
  expect_refusal(c.run(), c.path(w.file).string() + ":" + w.message);
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
}

const WrongLog wrong_logs[] = {
    {"times_that_do_not_ascend", "rig.csv", "0.02,62", "0.01,62",
     "4: time: found 0.01 s after 0.01 s, expected ascending times"},
    {"a_row_without_a_value", "rig.csv", "0.01,61,1", "0.01,61,-999.25",
     "3: ROP: found no value, \"-999.25\", expected a number in each row: fill the gap or cut the "
     "record"},
    {"a_top_that_turns_back", "rig.csv", "0.01,61", "0.01,-60",
     "3: RPM: found -6.28319 rad/s, expected a value, >= 0"},
    {"a_log_shorter_than_the_run", "case.toml", "\"20 ms\"", "\"30 ms\"",
     "23: string.top.log.file: found 0.02 s of a log for a run of 0.03 s, expected a log that "
     "lasts "
     "as long as the run"},
    {"a_start_before_the_log", "case.toml", "\"ROP\"", "\"ROP\"\nstart = \"-1 s\"",
     "26: string.top.log.start: found -1 s, expected a time of the log, 0 to 0.02 s"},
    {"block_speed_and_hook_load", "case.toml", "\"ROP\"", "\"ROP\"\nhook_load = \"HL\"",
     "25: string.top.log.block_speed: found hook_load as well, expected one of the two"},
    {"a_hook_load_of_a_lowered_top", "case.toml", "block_speed = \"ROP\"", "hook_load = \"HL\"",
     "25: string.top.log.hook_load: found a hook load without string.top.axial = \"hook-load\", "
     "expected none, or that key"},
    {"a_block_speed_of_a_top_that_hangs", "case.toml", "torsion = \"pi\"",
     "torsion = \"pi\"\naxial = \"hook-load\"",
     "26: string.top.log.block_speed: found a speed of the block without string.top.axial = "
     "\"rate\", expected none, or that key"},
    {"no_column", "case.toml", "rotary_speed = \"RPM\"\nblock_speed = \"ROP\"\n", "",
     "23: string.top.log.file: found a log without a column to use, expected rotary_speed, "
     "block_speed or hook_load: the name of a column"},
    {"a_speed_in_the_case_as_well", "case.toml", "[time]", "[motion]\nrotary_speed = 1\n[time]",
     "27: motion.rotary_speed: found a value in addition to that of the log, expected one of the "
     "two: see [string.top.log]"},
    {"a_rate_in_the_case_as_well", "case.toml", "[time]",
     "[motion]\nrate_of_penetration = 1\n[time]",
     "27: motion.rate_of_penetration: found a value in addition to that of the log, expected one "
     "of the two: see [string.top.log]"},
};

INSTANTIATE_TEST_SUITE_P(Logs, BadLog, ::testing::ValuesIn(wrong_logs),
                         [](const auto& w) { return std::string(w.param.name); });

TEST(StringCommand, lists_the_columns_of_a_log_where_one_is_missing) {
  const LogFolder c;
  c.edit("case.toml", "\"ROP\"", "\"SPPA\"");
  expect_refusal(c.run(), c.path("rig.csv").string() +
                              ":1: SPPA: found no column of this name, expected one of time, RPM, "
                              "ROP, HL");
}

TEST(StringCommand, runs_with_a_log_and_rejects_a_hook_load_beside_that_of_the_log) {
  const LogFolder c;
  EXPECT_EQ(c.run({"--quiet"}).exit_code, 0);
  c.edit("case.toml", "block_speed = \"ROP\"", "hook_load = \"HL\"");
  c.edit("case.toml", "torsion = \"pi\"", "torsion = \"pi\"\naxial = \"hook-load\"");
  EXPECT_EQ(c.run({"--quiet", "--force"}).exit_code, 0);
  c.edit("case.toml", "axial =", "hook_load = 1e5\naxial =");
  expect_refusal(c.run({"--force"}),
                 c.path("case.toml").string() +
                     ":19: string.top.hook_load: found a value in addition to that of the log, "
                     "expected one of the two: see [string.top.log]");
}

TEST(StringCommand, runs_and_rejects_to_overwrite) {
  const StringFolder c;
  const battery::Outcome first = c.run();
  EXPECT_EQ(first.exit_code, 0) << first.err;
  const std::string rows = read(c.path("out") / "history.csv");
  const battery::Outcome second = c.run();
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_EQ(c.run({"--force", "--quiet"}).exit_code, 0);
  EXPECT_EQ(read(c.path("out") / "history.csv"), rows);
}

TEST(StringCommand, warns_of_a_sharp_dogleg) {
  const StringFolder c;
  c.edit("case.toml", "\"300 m\", \"900 m\"]", "\"800 m\", \"900 m\"]");
  const battery::Outcome o = c.run();
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_NE(o.err.find("a dogleg of 18 deg in 30 m above station 3: check the stations"),
            std::string::npos)
      << o.err;
}

TEST(StringCommand, warns_of_buckling_where_the_hole_is_given) {
  const StringFolder c;
  c.edit("case.toml", "element_length", "hole_diameter = \"216 mm\"\nelement_length");
  c.edit("case.toml", "[motion]", "[motion]\nweight_at_start = \"200 kN\"");
  const battery::Outcome o = c.run();
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_NE(o.err.find("beyond sinusoidal buckling"), std::string::npos) << o.err;
}

TEST(StringCommand, warns_of_elements_too_long_for_the_blades) {
  const StringFolder c;
  c.edit("case.toml", "[motion]",
         "[string.bit]\nlaw = \"regenerative\"\naxial_stiffness = 1e6\n"
         "torsional_stiffness = 1e3\npitch = 0.3\n[motion]");
  const battery::Outcome o = c.run();
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_NE(o.err.find("string.element_length: elements of 20 m resolve waves up to 15.9 Hz, 10 "
                       "elements to a wavelength; the blades of the bit pass at 20.9 Hz: use at "
                       "most 15.2 m"),
            std::string::npos)
      << o.err;
}

TEST(StringCommand, rejects_a_case_of_another_kind_and_names_its_command) {
  const StringFolder c;
  const battery::Outcome o =
      battery::run_tdbd({"run", c.path("case.toml").string(), "-o", c.path("out").string()});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("try: tdbd string "), std::string::npos) << o.err;
}

}  // namespace tdbd::app::bad_string_test
