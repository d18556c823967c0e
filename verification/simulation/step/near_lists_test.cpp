#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "rock/index/near_list.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::near_lists_test {

/// Where a list has each vertex, -1 where it has not.
std::vector<int> places_of(const rock::NearList& list, int slots) {
  std::vector<int> places(at(slots), -1);
  for (std::size_t i = 0; i < list.v.size(); ++i) {
    if (list.v[i] == rock::no_vertex) continue;
    EXPECT_EQ(places[at(list.v[i])], -1) << "vertex " << list.v[i] << " twice";
    places[at(list.v[i])] = static_cast<int>(i);
  }
  return places;
}

/// How many vertices of the surface a list has; each is alive and in its place if it is in the
/// region, and the region has no other.
int check_list(const rock::NearList& list, const mesh::Surface& surface) {
  const std::vector<int> places = places_of(list, surface.vertex_slots());
  int held = 0;
  for (int v = 0; v < surface.vertex_slots(); ++v) {
    const int place = places[at(v)];
    EXPECT_TRUE(place < 0 || surface.is_alive(v)) << "vertex " << v;
    if (!surface.is_alive(v) || !is_between(list.region_W.slabs, surface.position(v))) continue;
    EXPECT_GE(place, 0) << "vertex " << v << " is missing";
    if (place < 0) continue;
    ++held;
    const Vec3 x_W = list.origin_W + Vec3(list.x[at(place)], list.y[at(place)], list.z[at(place)]);
    EXPECT_LT((x_W - surface.position(v)).norm(), rock::single_slack(list.region_W.box));
  }
  return held;
}

/// Drills with a maintenance every third step, so that steps and edits alternate.
void check_lists(const std::string& name, int steps) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml",
                           {"rock.edge_length='4 mm'", "maintenance.every=3", "rock.wall='12 mm'"});
  Simulation s = start(c);
  long lists = 0, held = 0;
  for (int k = 0; k < steps; ++k) {
    step(c, s);
    for (rock::NearList& list : s.state.rock.near_lists) {
      if (list.changes < s.state.rock.grid.journal().first) continue;  // out of reach
      const rock::Region inside = widened(list.region_W, -1e-9);
      ASSERT_TRUE(holds(list.region_W, inside));  // otherwise it would be built again
      update_near_list(s.state.rock.grid, {{}, {}, {}, inside}, {}, list);
      ++lists;
      held += check_list(list, s.state.rock.surface);
    }
  }
  fmt::print("{}: {} lists with {} vertices\n", name, lists, held);
  EXPECT_GT(held, 20 * lists);
}

TEST(NearLists, contain_all_of_their_regions_after_any_steps_and_maintenance) {
  check_lists("standard-workload", 60);
  check_lists("drill-bit-b", 60);
}

}  // namespace tdbd::simulation::near_lists_test
