#include "reference/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "reference/compare/comparison_files.hpp"

namespace tdbd::reference::comparison_test {
namespace {

/// Bit B on a coarse rock: quick, and every model speaks.
CompareCase coarse_case() {
  return read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b.toml",
                           {"rock.edge_length='3 mm'", "time.step='4 ms'", "time.revolutions=2"});
}

const Comparison& coarse() {
  static const Comparison all = [] {
    const CompareCase c = coarse_case();
    return compare(c, chosen_models(c, {"all"}), Refusal::stops, {});
  }();
  return all;
}

TEST(Comparison, every_blank_has_a_reason_and_every_number_none) {
  for (const Answer& a : coarse().answers)
    for (std::size_t i = 0; i < quantity_count; ++i) {
      const Saying& s = a.findings.says[i];
      EXPECT_NE(s.value.has_value(), !s.reason.empty())
          << a.model->name << ": " << quantity_texts()[i].name;
    }
}

TEST(Comparison, takes_its_reference_weight_from_the_first_that_says_one) {
  EXPECT_EQ(coarse().weight_from, "TDBD");
  EXPECT_EQ(coarse().weight, *saying(coarse().answers.front().findings, Quantity::weight).value);
}

TEST(Comparison, csv_has_a_row_for_every_model_and_quantity) {
  std::istringstream text(comparison_csv(coarse()));
  std::string line;
  std::size_t lines = 0;
  while (std::getline(text, line)) ++lines;
  EXPECT_EQ(lines, 1 + coarse().answers.size() * quantity_count);
}

/// Areas of cutters times their circles are their volumes, except beside the axis.
TEST(Comparison, areas_of_our_cutters_agree_with_what_they_remove) {
  const Answer& ours = coarse().answers.front();
  double sum = 0.0;
  for (const PartFinding& p : ours.findings.parts)
    if (p.quantity == PartQuantity::volume_per_revolution) sum += p.value;
  EXPECT_NEAR(sum, *saying(ours.findings, Quantity::removed_per_revolution).value, 1e-12 * sum);
}

}  // namespace
}  // namespace tdbd::reference::comparison_test
