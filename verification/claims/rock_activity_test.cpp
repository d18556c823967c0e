#include <algorithm>
#include <nlohmann/json.hpp>

#include "claims/rock_runs.hpp"
#include "reference/rock/facet_walk.hpp"
#include "rock/cut/swept_mesh.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/battery/shapes.hpp"

/// Counts for the counterparts of the thesis's activity diagrams (figs. 4.2, 4.3, 4.11, 4.13,
/// 4.15): how often runs took each branch of TDBD (reports/figures/activities).
namespace tdbd::claims::rock_activity_test {

using Json = nlohmann::ordered_json;

struct Counts {
  long steps = 0, boxes = 0, reached = 0, boxes_with_rock = 0;  // one box for each group and step
  long vertices = 0;                // of the surface, summed over the steps
  long listed = 0, candidates = 0;  // of near lists; left by the planes
  long tested = 0, moved = 0;       // paths examined and moves, in all passes
  long passes = 0, still_steps = 0;
  long maintenances = 0;
  double removed = 0.0;  // m3
};

long living(const mesh::Surface& s) {
  long n = 0;
  for (int v = 0; v < s.vertex_slots(); ++v) n += s.is_alive(v);
  return n;
}

/// Adds what one step did. The candidates of the first pass are those of the near groups.
void count(const simulation::Simulation& s, Counts& n) {
  ++n.steps;
  n.vertices += living(s.state.rock.surface);
  for (std::size_t i = 0; i < s.work.cut_work.groups.size(); ++i) {
    const rock::GroupCut& g = s.work.cut_work.groups[i];
    ++n.boxes;
    if (rock::is_out_of_reach(s.state.rock.grid, s.work.cut_work.motions[i])) continue;
    ++n.reached;
    n.boxes_with_rock += !g.near.places.empty();
    n.listed += static_cast<long>(s.state.rock.near_lists[i].v.size());
    n.candidates += static_cast<long>(g.near.places.size());
  }
  n.tested += s.state.cut.candidates;
  n.moved += s.state.cut.moved;
  n.passes += s.state.cut.passes;
  n.still_steps += s.state.cut.moved == 0;
  n.removed += s.state.cut.removed;
}

Counts counts_of(const simulation::Case& c) {
  simulation::Simulation s = simulation::start(c);
  Counts n;
  while (s.state.steps_done < c.time.steps) {
    simulation::step(c, s);
    count(s, n);
    n.maintenances += c.maintenance.every > 0 && s.state.steps_done % c.maintenance.every == 0;
  }
  return n;
}

Json row(const std::string& name, const Counts& n) {
  return {{"run", name},
          {"steps", n.steps},
          {"boxes", n.boxes},
          {"reached", n.reached},
          {"boxes_with_rock", n.boxes_with_rock},
          {"vertices", n.vertices},
          {"listed", n.listed},
          {"candidates", n.candidates},
          {"tested", n.tested},
          {"moved", n.moved},
          {"passes", n.passes},
          {"still_steps", n.still_steps},
          {"maintenances", n.maintenances},
          {"removed_m3", n.removed}};
}

/// Every branch takes what the one before it left.
void expect_a_flow(const Counts& n) {
  EXPECT_EQ(n.boxes % n.steps, 0);
  EXPECT_LE(n.reached, n.boxes);
  EXPECT_LE(n.boxes_with_rock, n.reached);
  EXPECT_LT(n.listed, n.vertices / n.steps * n.reached);
  EXPECT_LE(n.candidates, n.listed);
  EXPECT_GE(n.tested, n.candidates);
  EXPECT_GT(n.moved, 0);
  EXPECT_LE(n.moved, n.tested);
  EXPECT_GE(n.passes, 2 * n.steps - n.still_steps);  // the last pass moves nothing
  EXPECT_GT(n.maintenances, 0);
  EXPECT_GT(n.removed, 0.0);
}

TEST(RockActivity, of_drilling_runs_is_counted) {
  Json rows = Json::array();
  for (const auto& [name, file, settings] :
       {std::tuple("bit B", "bit-b-steady",
                   std::vector<std::string>{"rock.edge_length='2.5 mm'", "time.revolutions=2"}),
        std::tuple("bit R", "bit-r-rolling",
                   std::vector<std::string>{"rock.edge_length='3 mm'", "time.step='2 ms'",
                                            "time.revolutions=2"})}) {
    const Counts n = counts_of(rock_case(file, settings));
    expect_a_flow(n);
    rows.push_back(row(name, n));
  }
  battery::record_table("rock-activity", rows);
}

/// The walk over the facets of a part that is not convex. All cutting parts of our bits are convex,
/// so a torus is used: neighbouring vertices around it, in small steps.
TEST(RockActivity, of_walks_to_the_exit_is_counted) {
  const mesh::TriangleTree tree(battery::torus(1.0, 0.3, 64, 32));
  const reference::FacetNeighbours across = reference::neighbours_of(tree);
  constexpr double depth = 1e-9;
  reference::WalkScratch walking;
  rock::MeshScratch searching;
  long queries = 0, swept = 0, same = 0;
  for (double a = 0.0; a < 6.0; a += 1e-3) {
    const double r = 1.0 + 0.33 * std::sin(37.0 * a);
    const Vec3 x(r * std::cos(a), r * std::sin(a), 0.27 - 0.05 * std::cos(11.0 * a));
    const rock::RelativePath path{x, x + Vec3(0, 1e-3, -1e-3), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    const auto t = exit_distance_by_walk(tree, across, path, depth, walking);
    same += t == exit_distance(tree, path, depth, searching);
    ++queries;
    swept += t && *t > 0.0;
  }
  const reference::WalkMemory& walks = walking.walk;
  EXPECT_EQ(same, queries);
  EXPECT_GT(swept, 0);
  EXPECT_LT(walks.found, walks.tried);
  EXPECT_LE(walks.answered, walks.tried);
  battery::record_table("walk-activity", {{{"queries", queries},
                                           {"tried", walks.tried},
                                           {"found", walks.found},
                                           {"answered", walks.answered},
                                           {"swept", swept}}});
}

}  // namespace tdbd::claims::rock_activity_test
