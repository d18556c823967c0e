#include "forces/fits.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/error.hpp"
#include "forces/generate.hpp"

namespace tdbd::forces::fits_test {

TEST(KnownFits, lie_in_the_ranges_of_their_laws_and_have_a_source) {
  std::set<std::string_view> names;
  for (const Fit& fit : known_fits()) {
    EXPECT_TRUE(names.insert(fit.name).second) << fit.name;
    EXPECT_FALSE(fit.source.empty()) << fit.name;
    Law law = fit.law;
    for (const LawField& f : law_fields(law))
      EXPECT_TRUE(f.range.contains(*f.value)) << fit.name << ' ' << f.key;
  }
}

TEST(FitNamed, names_the_fits_that_there_are) {
  EXPECT_EQ(law_name(fit_named("glowka-berea-0.5in").law), "glowka");
  EXPECT_THROW(fit_named("glowka"), InputError);
}

/// The mean drag over normal force of the fits against the tests, for depths of 0.5 to 2 mm.
TEST(KnownFits, of_power_laws_have_the_ratios_of_their_tests) {
  for (const auto& [name, ratio] : {std::pair{"glowka-berea-0.5in", 1.22},
                                    {"glowka-berea-0.75in", 1.33},
                                    {"glowka-sierra-white-0.5in", 0.79},
                                    {"glowka-sierra-white-0.75in-blunt", 0.70}}) {
    const auto& law = std::get<Glowka>(fit_named(name).law);
    EXPECT_NEAR(law.Cd / law.Cn, ratio, 0.1 * ratio) << name;
  }
}

}  // namespace tdbd::forces::fits_test
