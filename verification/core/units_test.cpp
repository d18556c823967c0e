#include "core/units.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "core/units/unit_database.hpp"
#include "verification/battery/out_of_memory.hpp"

namespace tdbd::units_test {

constexpr double pi = std::numbers::pi;

/// The message of the error, or "" when the text was accepted.
std::string refusal(const std::string& text, const std::string& si_unit) {
  try {
    to_si(text, si_unit);
  } catch (const UnitError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const std::string& text, const std::string& si_unit,
                    const std::vector<std::string>& words) {
  const std::string message = refusal(text, si_unit);
  ASSERT_NE(message, "") << text << " was accepted as " << si_unit;
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
}

// The factors are the definitions: the inch of 25.4 mm, the pound of 0.45359237 kg, standard
// gravity of 9.80665 m/s2.
TEST(Units, converts_what_drillers_write) {
  EXPECT_DOUBLE_EQ(to_si("8.5 in", "m"), 8.5 * 0.0254);
  EXPECT_DOUBLE_EQ(to_si("8.5in", "m"), 8.5 * 0.0254);
  EXPECT_DOUBLE_EQ(to_si("13 mm", "m"), 0.013);
  EXPECT_DOUBLE_EQ(to_si("15 m/h", "m/s"), 15.0 / 3600.0);
  EXPECT_DOUBLE_EQ(to_si("50 ft/h", "m/s"), 50 * 0.3048 / 3600.0);
  EXPECT_DOUBLE_EQ(to_si("120 rpm", "rad/s"), 4 * pi);
  EXPECT_DOUBLE_EQ(to_si("12 deg", "rad"), pi / 15);
  EXPECT_DOUBLE_EQ(to_si("-12 deg", "rad"), -pi / 15);
  EXPECT_DOUBLE_EQ(to_si("20 klbf", "N"), 20e3 * 0.45359237 * 9.80665);
  EXPECT_NEAR(to_si("1 lbf", "N"), 0.45359237 * 9.80665, 1e-14);
  EXPECT_DOUBLE_EQ(to_si("3000 psi", "Pa"), 3000 * 0.45359237 * 9.80665 / (0.0254 * 0.0254));
  EXPECT_DOUBLE_EQ(to_si("10 ppg", "kg/m3"), 4.5359237 / (231 * 0.0254 * 0.0254 * 0.0254));
  EXPECT_DOUBLE_EQ(to_si("30 MPa", "Pa"), 30e6);
  EXPECT_DOUBLE_EQ(to_si("2.65 g/cm3", "kg/m3"), 2650);
  EXPECT_DOUBLE_EQ(to_si("1 min", "s"), 60);
  EXPECT_DOUBLE_EQ(to_si("60 rev/min", "rad/s"), 2 * pi);
  EXPECT_DOUBLE_EQ(to_si("25 degC", "K"), 298.15);
  EXPECT_DOUBLE_EQ(to_si("50 %", "1"), 0.5);
  EXPECT_DOUBLE_EQ(to_si("0.5", "1"), 0.5);
  EXPECT_DOUBLE_EQ(to_si("2 1/s", "1/s"), 2);
}

TEST(Units, returns_the_dimension_of_an_angle) {
  EXPECT_DOUBLE_EQ(to_si("1 revolution/s", "rad/s"), 2 * pi);
  EXPECT_DOUBLE_EQ(to_si("360 deg/s", "rad/s"), 2 * pi);
  expect_refusal("2 Hz", "rad/s", {"Hz", "frequency", "angular speed"});
  expect_refusal("2 1/s", "rad/s", {"frequency", "angular speed"});
  expect_refusal("2 rpm", "1/s", {"angular speed", "frequency"});
  expect_refusal("12 deg", "1", {"angle", "plain number"});
  expect_refusal("12 percent", "rad", {"plain number", "angle"});
}

TEST(Units, rejects_a_wrong_dimension_naming_both) {
  expect_refusal("8.5 kg", "m", {"8.5 kg", "mass", "length"});
  expect_refusal("20 klb", "N", {"mass", "force"});
  expect_refusal("3 A", "m", {"dimension A", "length"});
  expect_refusal("3 s", "1/s", {"s is time", "frequency"});  // UDUNITS-2 would take 1/(3 s)
  expect_refusal("3 s/m", "m/s", {"speed"});
  expect_refusal("3 seconds since 2000-01-01", "s", {"time"});
  expect_refusal("3 dBZ", "m", {"length"});
  expect_refusal("3 candela mol A kg2/K3", "m", {"is a unit of dimension kg2.A.K-3.mol.cd)"});
}

TEST(Units, rejects_what_is_not_a_number) {
  expect_refusal("", "m", {"number"});
  expect_refusal("in", "m", {"number"});
  expect_refusal("abc", "m", {"abc", "number"});
  expect_refusal("nan m", "m", {"finite"});
  expect_refusal("inf m", "m", {"finite"});
  expect_refusal("-inf m", "m", {"finite"});
  expect_refusal("1e999 m", "m", {"range"});
  expect_refusal("1e308 km", "m", {"range"});
}

/// The library would print its own message as well.
TEST(Units, rejects_with_its_own_message_only) {
  testing::internal::CaptureStderr();
  EXPECT_THROW(to_si("1 frobnicate", "m"), UnitError);
  EXPECT_THROW(to_si("1 m)(", "m"), UnitError);
  EXPECT_THROW(to_si("1 m^999", "m"), UnitError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Units, rejects_what_is_not_a_unit) {
  expect_refusal("8.5", "m", {"no unit", "length"});
  expect_refusal("8.5 inn", "m", {"unknown unit inn", "length"});
  expect_refusal("8 1/2 in", "m", {"second number", "did you mean \"8.5 in\"?"});
  expect_refusal("12-1/4 in", "m", {"second number", "did you mean \"12.25 in\"?"});
  expect_refusal("1/2 in", "m", {"second number", "did you mean \"0.5 in\"?"});
  expect_refusal("8 5 in", "m", {"second number"});
  for (const char* text : {"8 - 5 in", "8 in 3", "8 in*3", "8 in @ 3", "8 in.3", "8 1/2in", "8 -5"})
    expect_refusal(text, "m", {"second number"});
  for (const char* text : {"8 1/ s", "8 1/(s)", "8 1/", "8 1"})
    expect_refusal(text, "1/s", {"second number"});
  EXPECT_DOUBLE_EQ(to_si("2 m s-1", "m/s"), to_si("2 m.s^-1", "m/s"));
}

struct Spelling {
  const char* text;
  const char* si_unit;
  const char* same;  ///< the quantity as the library of units spells it
};

TEST(Units, accepts_other_spellings_that_have_one_meaning) {
  for (const Spelling& s : std::vector<Spelling>{{"7 Nm", "N m", "7 N m"},
                                                 {"7 kNm", "N m", "7 kN m"},
                                                 {"7 kN-m", "N m", "7 kN m"},
                                                 {"7 N\u00B7m", "N m", "7 N m"},
                                                 {"7 N\u22C5m", "N m", "7 N m"},
                                                 {"7 ft-lb", "N m", "7 ft lbf"},
                                                 {"7 ft-lbs", "N m", "7 ft lbf"},
                                                 {"7 lb-ft", "N m", "7 ft lbf"},
                                                 {"7 ft.lbf", "N m", "7 ft lbf"},
                                                 {"7 kft-lbf", "N m", "7 ft klbf"},
                                                 {"7 Nm/rad", "N m/rad", "7 N m/rad"},
                                                 {"7 RPM", "rad/s", "7 rpm"},
                                                 {"7 Rpm", "rad/s", "7 rpm"},
                                                 {"7 r/min", "rad/s", "7 rpm"},
                                                 {"7 rev/min", "rad/s", "7 rpm"},
                                                 {"7 rps", "rad/s", "7 rev/s"},
                                                 {"7 PSI", "Pa", "7 psi"},
                                                 {"7 ksi", "Pa", "7000 psi"},
                                                 {"7 kpsi", "Pa", "7000 psi"},
                                                 {"7 Mpa", "Pa", "7 MPa"},
                                                 {"7 KPA", "Pa", "7 kPa"},
                                                 {"7 kips", "N", "7 klbf"},
                                                 {"7 KN", "N", "7 kN"},
                                                 {"7 Klbf", "N", "7 klbf"},
                                                 {"7 LBF", "N", "7 lbf"},
                                                 {"7 fph", "m/s", "7 ft/h"},
                                                 {"7 ft/hr", "m/s", "7 ft/h"},
                                                 {"7 FT/HR", "m/s", "7 ft/h"},
                                                 {"7 m/hr", "m/s", "7 m/h"},
                                                 {"7 in.", "m", "7 in"},
                                                 {"7\"", "m", "7 in"},
                                                 {"7 MM", "m", "7 mm"},
                                                 {"7 \u00B5m", "m", "7 um"},
                                                 {"7 g/cc", "kg/m3", "7 g/cm3"},
                                                 {"7 lb/gal", "kg/m3", "7 ppg"},
                                                 {"7 kg/m\u00B3", "kg/m3", "7 kg/m3"},
                                                 {"7 m\u00B7s\u207B\u00B9", "m/s", "7 m/s"},
                                                 {"7 mm\u00B2", "m2", "7 mm2"},
                                                 {"7\u00B0", "rad", "7 deg"},
                                                 {"7 \u00B0C", "K", "7 degC"},
                                                 {"7 lbs", "kg", "7 lb"},
                                                 {"7 hrs", "s", "7 h"},
                                                 {"7\u00A0mm", "m", "7 mm"},
                                                 {"7\u2009mm", "m", "7 mm"},
                                                 {"7\u202Fmm", "m", "7 mm"},
                                                 {"\u22127 deg", "rad", "-7 deg"},
                                                 {"1,5 mm", "m", "1.5 mm"},
                                                 {"8,5 in", "m", "8.5 in"},
                                                 {"0,125 in", "m", "0.125 in"},
                                                 {"1,2345 in", "m", "1.2345 in"},
                                                 {"1,234,567 lbf", "N", "1234567 lbf"},
                                                 {"30,000.5 lbf", "N", "30000.5 lbf"},
                                                 {"1.234,5 lbf", "N", "1234.5 lbf"},
                                                 {"30 000 lbf", "N", "30000 lbf"},
                                                 {"30\u202F000 lbf", "N", "30000 lbf"},
                                                 {"0,5", "1", "0.5"}}) {
    EXPECT_EQ(refusal(s.text, s.si_unit), "") << s.text;
    if (!refusal(s.text, s.si_unit).empty()) continue;
    EXPECT_DOUBLE_EQ(to_si(s.text, s.si_unit), to_si(s.same, s.si_unit)) << s.text;
  }
}

TEST(Units, suggests_what_a_spelling_with_several_meanings_may_mean) {
  expect_refusal("30,000 lbf", "N", {"\"30000 lbf\" or \"30.000 lbf\"?", "decimals or thousands"});
  expect_refusal("-1,500 m", "m", {"\"-1500 m\" or \"-1.500 m\"?"});
  expect_refusal("20 klb", "N", {"did you mean \"20 klbf\"?"});
  expect_refusal("20 lbs", "N", {"did you mean \"20 lbf\"?"});
  expect_refusal("9 kg", "N", {"did you mean \"9 kgf\"?"});
  expect_refusal("30 mph", "m/s", {"did you mean \"30 m/h\" or \"30 mile/h\"?"});
  expect_refusal("5 mpa", "Pa", {"did you mean \"5 MPa\" or \"5 mPa\"?"});
  expect_refusal("100 psig", "Pa", {"did you mean \"100 psi\"?"});
  expect_refusal("2 Hz", "rad/s", {"did you mean \"2 rev/s\"?"});
  expect_refusal("60 1/min", "rad/s", {"did you mean \"60 rpm\"?"});
}

TEST(Units, the_program_itself_must_request_a_unit) {
  EXPECT_THROW(to_si("1 m", "metres per fortnigth"), RunError);
  EXPECT_THROW(describe_unit("inn"), RunError);
}

/// In a process of its own: the database is read once.
void exit_with_fortnights_beside(const char* elsewhere) {
  setenv("UDUNITS2_XML_PATH", elsewhere, 1);
  const bool same = to_si("1 fortnight", "s") == 14.0 * 86400.0;
  const char* kept = std::getenv("UDUNITS2_XML_PATH");
  _exit(same && kept != nullptr && std::string(kept) == elsewhere ? 0 : 1);
}

/// Units are those of the library's own database, independent of any other file, and the setting of
/// other programs is unchanged.
TEST(UnitsDeathTest, are_not_changed_by_a_database_elsewhere) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const std::string other = write_temporary(
      ".xml",
      "<?xml version=\"1.0\" encoding=\"US-ASCII\"?>\n<unit-system>\n<unit><base/><name><singular>"
      "second</singular></name><symbol>s</symbol></unit>\n<unit><def>3 second</def><name><singular>"
      "fortnight</singular></name></unit>\n</unit-system>\n");
  EXPECT_EXIT(exit_with_fortnights_beside(other.c_str()), testing::ExitedWithCode(0), "");
}

/// The library would crash in the middle of its work: it is not even begun.
TEST(MemoryLeftForUnits, is_demanded_before_a_text_is_read) {
  EXPECT_TRUE(
      battery::throws_for_want_of_memory([] { return units::find_in_udunits("m") != nullptr; },
                                         [](bool) { units::find_in_udunits("furlong"); }));
}

/// With room for a text, but not for the database.
void exit_with_the_demand_of_the_database() {
  if (!battery::limit_memory(6'000'000)) _exit(2);
  try {
    units::find_in_udunits("m");
  } catch (const std::bad_alloc&) {
    _exit(0);
  }
  _exit(1);
}

TEST(MemoryLeftForUnitsDeathTest, is_demanded_before_the_database_is_read) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exit_with_the_demand_of_the_database(), testing::ExitedWithCode(0), "");
}

RC_GTEST_PROP(Units, any_text_is_a_finite_value_or_an_error, (const std::string& tail)) {
  for (const std::string& text : {tail, "1 " + tail, "1 m" + tail}) {
    try {
      RC_ASSERT(std::isfinite(to_si(text, "m")));
    } catch (const UnitError& error) {
      RC_ASSERT(!error.found.empty() && !error.expected.empty());
    }
  }
}

RC_GTEST_PROP(Units, conversion_is_proportional, (int thousandths)) {
  const double x = thousandths / 1000.0;
  RC_ASSERT(std::abs(to_si(fmt::format("{} in", x), "m") - x * 0.0254) <= 1e-15 * std::abs(x));
}

/// UDUNITS-2 knows no threads, so callers take turns.
TEST(Units, may_be_read_in_several_threads) {
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&wrong] {
        for (int i = 0; i < 2000; ++i) {
          if (to_si("8.5 in", "m") != 0.2159) ++wrong;
          if (describe_unit("m") != "length in m") ++wrong;
        }
      });
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace tdbd::units_test
