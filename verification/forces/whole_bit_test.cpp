#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "bit/cutter/cutter_table.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/observed_order.hpp"
#include "forces/generate.hpp"
#include "forces/law.hpp"
#include "forces/laws/laws.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"

namespace tdbd::forces::whole_bit_test {

constexpr double advance = 3e-3;    // m per revolution
constexpr double column = 0.01e-3;  // m

/// A rock of 100 MPa, 0.8, sharp.
Detournay rock_k() { return {.eps = 100 * MPa, .zeta = 0.8, .slip_speed = 0.0}; }

struct BitLoad {
  double weight = 0.0;                                  // N
  double torque = 0.0;                                  // N m
  Eigen::Vector2d imbalance = Eigen::Vector2d::Zero();  // N
  double volume = 0.0;                                  // m3 per revolution
};

/// A cutter's cut in the radial plane, at the arm that its volume has.
PartCut cut_of(const bit::Cutter& c, double area, double volume) {
  const double arm = volume / (2 * pi * area);
  const Vec3 out(std::cos(c.azimuth), std::sin(c.azimuth), 0.0);
  PartCut cut;
  cut.kind = bit::PartKind::face;
  cut.cut_area = area;
  cut.point = arm * out;
  cut.velocity = 4 * pi * arm * Vec3(-out.y(), out.x(), 0.0);
  cut.normal = std::sin(c.profile_angle) * out + std::cos(c.profile_angle) * Vec3::UnitZ();
  return cut;
}

std::vector<bit::Cutter> cutters_of(char letter) {
  bit::CutterDefaults chamfered;
  chamfered.chamfer = 0.4e-3;
  return bit::read_cutter_table(std::string(TDBD_SOURCE_DIR "/cases/bits/bit-") + letter + ".csv",
                                chamfered);
}

/// Sum over the cutters of what cuts in the radial plane (areas and volumes) make them feel.
template <class Cuts>
BitLoad load_of(const std::vector<bit::Cutter>& cutters, const Cuts& cuts) {
  BitLoad sum;
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    if (cuts.area[k] == 0.0) continue;
    const PartForce f = law_force(rock_k(), cut_of(cutters[k], cuts.area[k], cuts.volume[k]));
    sum.weight -= f.force.z();
    sum.imbalance += f.force.head<2>();
    sum.torque -= f.point.cross(f.force).z();
    sum.volume += cuts.volume[k];
  }
  return sum;
}

struct Row {
  char bit;
  double weight, torque, imbalance;  // N, N m, % of the weight
};

/// The planar model of Warren and Sinor, at 3 mm per revolution, printed to 0.1 N and 0.01 %. The
/// torque is eps R^2 d/2 whatever the layout.
TEST(WholeBit, of_sharp_cutters_has_the_loads_of_warren_and_sinors_model) {
  for (const Row& r : {Row{'a', 22779.2, 1747.980375, 0.85},
                       {'b', 22414.8, 1747.980375, 7.94},
                       {'c', 22589.3, 1747.980375, 2.54}}) {
    const auto cutters = cutters_of(r.bit);
    const BitLoad b = load_of(cutters, reference::planar_cut(cutters, advance, column));
    EXPECT_NEAR(b.weight, r.weight, 0.1) << r.bit;
    EXPECT_NEAR(b.torque, r.torque, 1e-12 * r.torque) << r.bit;
    EXPECT_NEAR(b.imbalance.norm() / b.weight * 100, r.imbalance, 0.015) << r.bit;
  }
}

/// With outlines turned about the axis, which the bit's room has, a core stays and cutter 1 carries
/// less: 0.59, 0.50 and 0.78 % of the weight, nothing of the torque.
TEST(WholeBit, with_its_core_carries_a_little_less_weight) {
  for (const char letter : {'a', 'b', 'c'}) {
    const auto cutters = cutters_of(letter);
    const BitLoad plane = load_of(cutters, reference::planar_cut(cutters, advance, column));
    const BitLoad turned = load_of(cutters, bit::engagement(cutters, advance, column));
    EXPECT_LT(turned.weight, 0.9955 * plane.weight) << letter;
    EXPECT_GT(turned.weight, 0.9915 * plane.weight) << letter;
    EXPECT_NEAR(turned.torque, plane.torque, 1.4e-4 * plane.torque) << letter;
  }
}

/// The torque does the work of cutting, whatever the layout: T = eps V/(2 pi), eps R^2 d/2 in all.
TEST(WholeBit, of_sharp_cutters_has_the_torque_of_its_volume) {
  for (const char letter : {'a', 'b', 'c'}) {
    const auto cutters = cutters_of(letter);
    const BitLoad b = load_of(cutters, bit::engagement(cutters, advance, column));
    EXPECT_NEAR(b.torque, 100 * MPa * b.volume / (2 * pi), rounding(b.torque)) << letter;
  }
}

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

}  // namespace tdbd::forces::whole_bit_test
