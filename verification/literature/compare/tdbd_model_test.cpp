#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "literature/compare/asked_models.hpp"

/// What the comparison reads off our own run, against what steady drilling must give.
namespace tdbd::reference::tdbd_model_test {
namespace {

constexpr double reach = 107.95e-3, eps = 100e6;  // m, Pa

/// Two revolutions count, so that what belongs to one is not what belongs to all.
CompareCase two_counted() {
  return asked::compare_case(
      "bit-b", {"rock.edge_length='2 mm'", "time.step='2 ms'", "compare.counted_revolutions=2"});
}

const Findings& ours() {
  static const Findings f = asked::ask(two_counted(), "tdbd", 0.0);
  return f;
}

std::map<std::string, double> numbers_of(const Findings& f, PartQuantity q) {
  std::map<std::string, double> numbers;
  for (const PartFinding& p : f.parts)
    if (p.quantity == q) numbers[p.part] = p.value;
  return numbers;
}

TEST(TdbdModel, says_volumes_of_one_revolution) {
  const double disc = std::numbers::pi * reach * reach * two_counted().advance;
  EXPECT_NEAR(asked::value(ours(), Quantity::removed_per_revolution), disc, 1.2e-3 * disc);
  double sum = 0.0;
  for (const auto& [part, volume] : numbers_of(ours(), PartQuantity::volume_per_revolution))
    sum += volume;
  EXPECT_NEAR(sum, disc, 1.2e-3 * disc);
}

/// A sharp face drags eps times its area normal to the helix; seen along the circle the area is larger
/// by 1/cos of the helix's angle, less than 1e-3 beyond 10 mm. The tip stands for the face, where the helix is a little steeper.
TEST(TdbdModel, says_areas_that_its_drag_has) {
  const auto drags = numbers_of(ours(), PartQuantity::drag);
  int cutters = 0;
  for (const PartFinding& p : ours().parts)
    if (p.quantity == PartQuantity::area && p.radius > 10e-3) {
      const double helix = two_counted().advance / (2 * std::numbers::pi * p.radius);
      EXPECT_NEAR(p.value * eps / drags.at(p.part), std::hypot(1.0, helix), 1.3e-6) << p.part;
      ++cutters;
    }
  EXPECT_EQ(cutters, 27);
}

TEST(TdbdModel, moves_no_cutter_backwards_in_steady_drilling) {
  EXPECT_EQ(asked::value(ours(), Quantity::share_moved_backwards), 0.0);
}

/// Behr's planes cut the same bottom; at 100 mm it falls by 1.5 mm a millimetre of radius.
TEST(TdbdModel, shows_the_bottom_on_the_circle_that_was_asked_for) {
  const Findings planes = asked::ask(two_counted(), "behr", 0.0);
  const auto mean = [](const BottomCircle& c) {
    return std::accumulate(c.depth.begin(), c.depth.end(), 0.0) /
           static_cast<double>(c.depth.size());
  };
  ASSERT_TRUE(ours().bottom && planes.bottom);
  EXPECT_NEAR(mean(*ours().bottom), mean(*planes.bottom), 0.2e-3);
}

/// The drag of a led bit's cutter, too, is eps times its area, against its turning.
TEST(TdbdModel, has_the_drag_of_led_bits) {
  const Findings led = asked::ask(two_counted(), "langeveld", 0.0);
  const auto drags = numbers_of(led, PartQuantity::drag);
  for (const auto& [part, area] : numbers_of(led, PartQuantity::area))
    EXPECT_NEAR(drags.at(part), eps * area, 2e-3 * eps * area) << part;
}

}  // namespace
}  // namespace tdbd::reference::tdbd_model_test
