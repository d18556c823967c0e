#include "forces/fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/observed_order.hpp"
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

/// C x^n by least squares in the logarithms.
struct PowerLaw {
  double C = 0.0, n = 0.0;
};

PowerLaw fitted(const std::vector<double>& x, const std::vector<double>& y) {
  double log_x = 0.0, log_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    log_x += std::log(x[i]) / static_cast<double>(x.size());
    log_y += std::log(y[i]) / static_cast<double>(x.size());
  }
  const double n = least_squares_order(x, y);
  return {std::exp(log_y - n * log_x), n};
}

/// The columns of the measured rows of one case: in, lbf, lbf.
struct Measured {
  std::vector<double> depth, normal, drag;
};

Measured rows_of(const std::string& name) {
  Measured m;
  for (const CsvRow& row :
       read_csv_rows(TDBD_SOURCE_DIR "/validation/data/single-cutters/rows.csv")) {
    if (row.cells.front() != name) continue;
    m.depth.push_back(csv_number<double>(row.cells[4]).value());
    m.normal.push_back(csv_number<double>(row.cells[5]).value());
    m.drag.push_back(csv_number<double>(row.cells[6]).value());
  }
  return m;
}

/// A coefficient at 1 mm in N against one at 1 in in lbf: written without decimals, its power with two.
void expect_rounded(double at_mm, double power, const PowerLaw& found) {
  constexpr double lbf = 4.4482216152605, inch_in_mm = 25.4;  // N, mm
  EXPECT_NEAR(at_mm / lbf * std::pow(inch_in_mm, power), found.C, 0.5);
  EXPECT_NEAR(power, found.n, 0.005);
}

/// Zijsling's and the sharp cutters' fits know a face alone: what is assumed of chamfers and other surfaces is the
/// same in all, and nothing of edges.
TEST(KnownFits, of_faces_share_what_is_assumed_of_other_surfaces) {
  int found = 0;
  for (const Fit& fit : known_fits()) {
    const auto* law = std::get_if<HansonHansen>(&fit.law);
    if (law == nullptr) continue;
    ++found;
    EXPECT_EQ(law->A5, 1.34) << fit.name;
    EXPECT_EQ(law->A6, 0.6) << fit.name;
    EXPECT_EQ(law->A7, 0.5) << fit.name;
    EXPECT_EQ(law->A8, 0.3) << fit.name;
    EXPECT_EQ(law->A2, 0.0) << fit.name;
    EXPECT_EQ(law->A4, 0.0) << fit.name;
  }
  EXPECT_EQ(found, 3);
}

TEST(KnownFits, of_power_laws_are_least_squares_of_measured_rows) {
  for (const auto& [name, rows] :
       {std::pair{"glowka-berea-0.5in", "J BSS 0.5in BR20 sharp"},
        {"glowka-berea-0.75in", "K BSS 0.75in BR20 sharp"},
        {"glowka-sierra-white-0.5in", "J SWG 0.5in BR20 sharp"},
        {"glowka-sierra-white-0.75in-blunt", "D SWG 0.75in BR20 blunt Aw=.02"}}) {
    const auto& law = std::get<Glowka>(fit_named(name).law);
    const Measured m = rows_of(rows);
    ASSERT_GT(m.depth.size(), 10u) << rows;
    SCOPED_TRACE(name);
    expect_rounded(law.Cn, law.nn, fitted(m.depth, m.normal));
    expect_rounded(law.Cd, law.nd, fitted(m.depth, m.drag));
  }
}

}  // namespace tdbd::forces::fits_test
