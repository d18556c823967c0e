#include <gtest/gtest.h>

#include "simulation/start/rock_start.hpp"

namespace tdbd::simulation::reach_test {

/// m, of bit B at 15 m/h and 120 rpm for a second.
double gap(const std::vector<std::string>& settings) {
  std::vector<std::string> all{"rock.edge_length='8 mm'", "time.revolutions=2"};
  all.insert(all.end(), settings.begin(), settings.end());
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml", all);
  return gap_along_path(c, start_rock(c).surface);
}

TEST(GapOnTheWay, is_zero_for_a_bit_in_its_hole) { EXPECT_EQ(gap({}), 0.0); }

/// The sphere around the bit's cutters has a radius between the gage radius and twice that.
TEST(GapOnTheWay, is_the_distance_less_what_the_bit_may_reach) {
  for (const double far : {1.0, 100.0}) {
    const std::string x = std::to_string(far);
    for (const std::string& start :
         {"[0, 0, -" + x + "]", "[" + x + ", 0, 0]", "[0, -" + x + ", 0]"}) {
      EXPECT_LT(gap({"motion.start=" + start}), far - 0.1);
      EXPECT_GT(gap({"motion.start=" + start}), far - 0.4);
    }
  }
}

/// A bit that starts high up and comes down in time reaches the rock.
TEST(GapOnTheWay, includes_the_whole_path) {
  const std::vector<std::string> high = {"motion.start=[0, 0, -1]"};
  EXPECT_GT(gap(high), 0.0);
  EXPECT_EQ(gap({high[0], "motion.rate_of_penetration=1 m/s"}), 0.0);
  EXPECT_GT(gap({high[0], "motion.rate_of_penetration=-1 m/s"}), 0.0);
}

}  // namespace tdbd::simulation::reach_test
