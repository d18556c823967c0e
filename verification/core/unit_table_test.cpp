#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/units/unit_database.hpp"

namespace tdbd::core::unit_table_test {

using units::find_in_table;
using units::find_in_udunits;

/// Each with an SI unit of its dimension.
const std::vector<std::pair<std::string, std::string>> names{{"1", "1"},
                                                             {"%", "1"},
                                                             {"percent", "1"},
                                                             {"m", "m"},
                                                             {"mm", "m"},
                                                             {"cm", "m"},
                                                             {"dm", "m"},
                                                             {"km", "m"},
                                                             {"um", "m"},
                                                             {"nm", "m"},
                                                             {"meter", "m"},
                                                             {"meters", "m"},
                                                             {"millimeters", "m"},
                                                             {"metre", "m"},
                                                             {"micron", "m"},
                                                             {"in", "m"},
                                                             {"inch", "m"},
                                                             {"ft", "m"},
                                                             {"foot", "m"},
                                                             {"feet", "m"},
                                                             {"yd", "m"},
                                                             {"yard", "m"},
                                                             {"g", "kg"},
                                                             {"kg", "kg"},
                                                             {"mg", "kg"},
                                                             {"kilogram", "kg"},
                                                             {"t", "kg"},
                                                             {"tonne", "kg"},
                                                             {"lb", "kg"},
                                                             {"pound", "kg"},
                                                             {"s", "s"},
                                                             {"ms", "s"},
                                                             {"us", "s"},
                                                             {"second", "s"},
                                                             {"seconds", "s"},
                                                             {"min", "s"},
                                                             {"minute", "s"},
                                                             {"minutes", "s"},
                                                             {"h", "s"},
                                                             {"hr", "s"},
                                                             {"hour", "s"},
                                                             {"hours", "s"},
                                                             {"d", "s"},
                                                             {"day", "s"},
                                                             {"days", "s"},
                                                             {"Hz", "1/s"},
                                                             {"kHz", "1/s"},
                                                             {"1/s", "1/s"},
                                                             {"s-1", "1/s"},
                                                             {"K", "K"},
                                                             {"degC", "K"},
                                                             {"rad", "rad"},
                                                             {"mrad", "rad"},
                                                             {"deg", "rad"},
                                                             {"degree", "rad"},
                                                             {"degrees", "rad"},
                                                             {"rev", "rad"},
                                                             {"revolution", "rad"},
                                                             {"revolutions", "rad"},
                                                             {"rpm", "rad/s"},
                                                             {"rev/min", "rad/s"},
                                                             {"deg/s", "rad/s"},
                                                             {"N", "N"},
                                                             {"kN", "N"},
                                                             {"MN", "N"},
                                                             {"kgf", "N"},
                                                             {"lbf", "N"},
                                                             {"klbf", "N"},
                                                             {"Pa", "Pa"},
                                                             {"kPa", "Pa"},
                                                             {"MPa", "Pa"},
                                                             {"GPa", "Pa"},
                                                             {"bar", "Pa"},
                                                             {"atm", "Pa"},
                                                             {"psi", "Pa"},
                                                             {"J", "N m"},
                                                             {"kJ", "N m"},
                                                             {"W", "W"},
                                                             {"kW", "W"},
                                                             {"m/h", "m/s"},
                                                             {"ft/h", "m/s"},
                                                             {"ft/hr", "m/s"},
                                                             {"mm/s", "m/s"},
                                                             {"m/min", "m/s"},
                                                             {"m/s2", "m/s2"},
                                                             {"m/s^2", "m/s2"},
                                                             {"mm2", "m2"},
                                                             {"in2", "m2"},
                                                             {"mm^3", "m3"},
                                                             {"kg/m3", "kg/m3"},
                                                             {"g/cm3", "kg/m3"},
                                                             {"ppg", "kg/m3"},
                                                             {"lb/ft3", "kg/m3"},
                                                             {"N m", "N m"},
                                                             {"kN m", "N m"},
                                                             {"N.m", "N m"},
                                                             {"ft lbf", "N m"},
                                                             {"N m/rad", "N m/rad"},
                                                             {"N m/deg", "N m/rad"},
                                                             {"N m s/rad", "N m s/rad"},
                                                             {"kg m2", "kg m2"},
                                                             {"N/m", "N/m"},
                                                             {"kN/mm", "N/m"},
                                                             {"lbf/in", "N/m"},
                                                             {"N s/m", "N s/m"},
                                                             {"N/mm2", "Pa"},
                                                             {"MJ/m3", "Pa"}};

/// Relative error of a conversion: TDBD and the library round their product of factors at different
/// places.
constexpr double rounding = 6e-16;  // 4.8e-16 seen

// Every name that the table knows means what UDUNITS-2 means by it.
TEST(UnitTable, converts_as_udunits_does) {
  double worst = 0.0;
  for (const auto& [name, si] : names) {
    const auto ours = find_in_table(name), its = find_in_udunits(name);
    ASSERT_TRUE(its) << name;
    ASSERT_TRUE(ours) << name;
    EXPECT_EQ(ours->powers(), its->powers()) << name;
    for (const double x : {1.0, 120.0, 0.3, -7.25, 8.5, 3000.0}) {
      const double a = ours->convert(x, *find_in_table(si)),
                   b = its->convert(x, *find_in_udunits(si));
      worst = std::max(worst, std::abs(a - b) / std::abs(b));
      EXPECT_NEAR(a, b, rounding * std::abs(b)) << x << " " << name;
      const double size =
          name == "degC" ? std::abs(a) : std::abs(x);  // a sum rounds as its larger part does
      EXPECT_NEAR(find_in_table(si)->convert(a, *ours), x, 2.0 * rounding * size) << name;
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

/// 20 degC are 293 150 mK: a shift and a scale at once, there and back.
TEST(UnitTable, converts_temperatures_with_prefixes) {
  const auto celsius = find_in_table("degC"), milli = find_in_table("mK");
  ASSERT_TRUE(celsius && milli);
  EXPECT_NEAR(celsius->convert(20.0, *milli), 293150.0, rounding * 293150.0);
  EXPECT_NEAR(milli->convert(293150.0, *celsius), 20.0, rounding * 293.15);
  EXPECT_NEAR(find_in_udunits("degC")->convert(20.0, *find_in_udunits("mK")), 293150.0,
              rounding * 293150.0);
}

TEST(UnitTable, rejects_unknown_units) {
  for (const char* name : {"", "furlong", "m m/", "mm//s", "kin", "mft", "degC2", "degC/m", "m 2",
                           "m^", "/s", "2 m", "kkg", "mdeg", "12", "10/s", "m/12", "1.5"})
    EXPECT_FALSE(find_in_table(name)) << name;
}

/// A word of letters that units have.
rc::Gen<std::string> like_a_unit() {
  return rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("mkgsNPaHzradin ftlb/2.^-1Mh")));
}

// What it accepts of nonsense, UDUNITS-2 accepts in the same dimension: it never reads a unit as another.
RC_GTEST_PROP(UnitTable, reads_no_unit_as_another, ()) {
  for (int i = 0; i < 20; ++i) {
    const std::string name = *rc::gen::resize(12, like_a_unit());
    const auto ours = find_in_table(name);
    if (!ours) continue;
    const auto its = find_in_udunits(name);
    RC_ASSERT(its);
    RC_ASSERT(ours->powers() == its->powers());
  }
}

/// "m.s-1" of its powers.
std::string base_of(const units::UnitPowers& powers) {
  std::string text;
  for (const auto& [base, power] : powers)
    text += (text.empty() ? "" : ".") + base + std::to_string(power);
  return text.empty() ? "1" : text;
}

/// As it is written, with one character more, less, or another one.
std::vector<std::string> near(const std::string& name) {
  std::vector<std::string> all{name};
  for (std::size_t i = 0; i <= name.size(); ++i) {
    if (i < name.size()) all.push_back(std::string(name).erase(i, 1));
    for (const char c : std::string("kmMGdcunsNtgrx_12^/.- ")) {
      all.push_back(std::string(name).insert(i, 1, c));
      if (i < name.size()) (all.emplace_back(name))[i] = c;
    }
  }
  return all;
}

/// "mins": UDUNITS-2 has no plurals of symbols.
bool is_a_plural(const std::string& name) {
  for (std::size_t at = 0; (at = name.find('s', at)) != std::string::npos; ++at)
    if (find_in_udunits(std::string(name).erase(at, 1))) return true;
  return false;
}

/// A slip of the finger gives the unit that UDUNITS-2 reads, of the same size, or none;
/// but for plurals of symbols.
TEST(UnitTable, reads_names_that_are_nearly_units_as_udunits_does) {
  long read = 0;
  for (const auto& [name, si] : names)
    for (const std::string& nearly : near(name)) {
      const auto ours = find_in_table(nearly);
      if (!ours) continue;
      const auto its = find_in_udunits(nearly);
      if (!its) {
        EXPECT_TRUE(is_a_plural(nearly)) << nearly;
        continue;
      }
      ASSERT_EQ(ours->powers(), its->powers()) << nearly;
      const std::string base = base_of(ours->powers());
      const double a = ours->convert(3.0, *find_in_table(base)),
                   b = its->convert(3.0, *find_in_udunits(base));
      EXPECT_NEAR(a, b, 10.0 * rounding * std::abs(b)) << nearly;  // of powers; 6e-16 seen
      ++read;
    }
  EXPECT_GT(read, 1000);
}

/// Blanks about an asterisk are no mistake here, though UDUNITS-2 takes none.
TEST(UnitTable, multiplies_by_asterisks) {
  for (const char* name : {"N*m", "N * m", "N *m", "N* m"}) {
    ASSERT_TRUE(find_in_table(name)) << name;
    EXPECT_EQ(find_in_table(name)->powers(), find_in_table("J")->powers()) << name;
  }
}

/// For messages: in base units, with its scale.
TEST(UnitTable, defines_units_in_base_units) {
  const auto definition = [](const char* name) { return find_in_table(name)->definition(); };
  EXPECT_EQ(definition("m"), "m");
  EXPECT_EQ(definition("1"), "");
  EXPECT_EQ(definition("N"), "kg.m.s-2");
  EXPECT_EQ(definition("kN/mm2"), "1e+09 kg.m-1.s-2");
  EXPECT_EQ(definition("rad/s"), "rad.s-1");
  EXPECT_EQ(definition("cm"), "0.01 m");
}

}  // namespace tdbd::core::unit_table_test
