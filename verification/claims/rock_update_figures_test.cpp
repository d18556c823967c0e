#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bit/report/bit_output.hpp"
#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "reference/rock/prism.hpp"
#include "rock/cut/group_cut.hpp"
#include "rock/cut/swept_part.hpp"
#include "verification/battery/shapes.hpp"

/// Tables for the figures of sections 4.1 and 4.3: what the running code found, mapped, moved and
/// measured (reports/figures).
namespace tdbd::claims::rock_update_figures_test {

using Json = nlohmann::ordered_json;

Json list(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

Json corners(const Pose& X_WP, const mesh::TriangleMesh& m, const mesh::Triangle& t) {
  Json all = Json::array();
  for (const int v : t) all.push_back(list(X_WP * m.positions[static_cast<std::size_t>(v)]));
  return all;
}

/// One step of one cutter of the shoulder of bit B, on rock that the whole bit drilled before.
struct OneStep {
  simulation::Case c =
      rock_case("bit-b-steady", {"rock.edge_length='2.5 mm'", "time.revolutions=0.5",
                                 "time.step='5 ms'", "motion.rate_of_penetration='60 m/h'"});
  simulation::Simulation s = drilled(c);
  rock::CuttingBit cutter = s.work.cutting;
  Pose X_WB0 = pose_at(c.motion, 0.25), X_WB1 = pose_at(c.motion, 0.262);
  rock::Rock after;
  rock::CutReport report;

  OneStep() {
    constexpr int shoulder = 15;
    std::erase_if(cutter.groups, [&](const rock::CuttingGroup& g) {
      return c.bit.parts[static_cast<std::size_t>(g.parts.front().part)].cutter != shoulder;
    });
    after = s.state.rock;
    rock::CutWorkspace work;
    rock::cut_rock(after, cutter, X_WB0, X_WB1, work, report);
  }
  const rock::CuttingGroup& group() const { return cutter.groups.front(); }
};

Json part_rows(const OneStep& one) {
  Json rows = Json::array();
  for (const rock::CuttingPart& p : one.group().parts) {
    const bit::Part& part = one.c.bit.parts[static_cast<std::size_t>(p.part)];
    for (int pose = 0; pose < 2; ++pose) {
      const Pose X_WP = (pose == 0 ? one.X_WB0 : one.X_WB1) * one.group().X_BP;
      for (const mesh::Triangle& t : part.mesh_P.triangles)
        rows.push_back({{"what", "part"},
                        {"pose", pose},
                        {"kind", bit::kind_name(part.kind)},
                        {"corners", corners(X_WP, part.mesh_P, t)}});
    }
  }
  return rows;
}

/// Vertices within 8 mm of the motion box: where they were, whether the search offered them, and
/// for those that moved the mapped direction and where they went.
Json vertex_rows(const OneStep& one, long& moved) {
  const rock::GroupMotion motion = group_motion(one.group(), one.X_WB0, one.X_WB1);
  rock::NearList near_list;
  rock::NearGroup near_group;
  update_near_list(one.s.state.rock.grid,
                   {one.group().box_P, motion.X_WP0, motion.X_WP1, motion.region_W}, {}, near_list);
  find_candidates(one.group(), motion, one.s.state.rock.surface, near_list, -1.0, near_group);
  std::vector<int>& candidates = near_group.places;
  for (int& v : candidates) v = near_list.v[static_cast<std::size_t>(v)];
  mesh::Box near = motion.region_W.box;
  near.lo -= Vec3::Constant(8e-3);
  near.hi += Vec3::Constant(8e-3);
  Json rows = Json::array();
  for (int v = 0; v < one.s.state.rock.surface.vertex_slots(); ++v) {
    const Vec3 &from = one.s.state.rock.surface.position(v), &to = one.after.surface.position(v);
    if (!one.s.state.rock.surface.is_alive(v) || !near.contains(from)) continue;
    const bool is_moved = from != to;
    moved += is_moved;
    rows.push_back({{"what", "vertex"},
                    {"from", list(from)},
                    {"to", list(to)},
                    {"direction", list(mapped_direction_W(one.group(), motion, from))},
                    {"candidate", std::ranges::count(candidates, v) > 0},
                    {"moved", is_moved}});
    EXPECT_TRUE(!is_moved || std::ranges::count(candidates, v) > 0);
  }
  rows.push_back({{"what", "box"},
                  {"low", list(motion.region_W.box.lo)},
                  {"high", list(motion.region_W.box.hi)}});
  return rows;
}

/// Triangles of which a corner moved, with the volume of the prism between old and new.
Json prism_rows(const OneStep& one, double& sum) {
  Json rows = Json::array();
  const mesh::Surface &before = one.s.state.rock.surface, &after = one.after.surface;
  for (const mesh::Triangle& t : before.triangles) {
    if (t[0] < 0) continue;
    reference::Corners from, to;
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = before.position(t[i]);
      to[i] = after.position(t[i]);
    }
    if (from == to) continue;
    const double volume = reference::prism_volume(from, to);
    sum += volume;
    rows.push_back({{"from", {list(from[0]), list(from[1]), list(from[2])}},
                    {"to", {list(to[0]), list(to[1]), list(to[2])}},
                    {"volume", volume}});
  }
  return rows;
}

TEST(RockFigures, show_one_step_of_one_cutter) {
  const OneStep one;
  long moved = 0;
  Json rows = vertex_rows(one, moved);
  EXPECT_GT(moved, 20);
  for (const Json& row : part_rows(one)) rows.push_back(row);
  battery::record_table("one-step", rows);
}

TEST(RockFigures, show_the_prisms_of_the_step) {
  const OneStep one;
  double sum = 0.0;
  const Json rows = prism_rows(one, sum);
  battery::record_table("prisms", rows);
  record_bound("chapter4/volume",
               "one step of one cutter of bit B: sum of prisms against the change of the hole, "
               "relative",
               std::abs(sum / (mesh::hole_volume(one.after.surface, Vec3::Zero()) -
                               mesh::hole_volume(one.s.state.rock.surface, Vec3::Zero())) -
                        1.0),
               "1", 1e-12);
}

/// The deepest of the wanted parts.
template <class Wanted>
const rock::CuttingGroup& deepest_tooth(const simulation::Case& c, const rock::CuttingBit& bit,
                                        const Wanted& wanted) {
  const rock::CuttingGroup* best = nullptr;
  double depth = -1e300;
  for (const rock::CuttingGroup& g : bit.groups) {
    const bit::Part& part = c.bit.parts[static_cast<std::size_t>(g.parts.front().part)];
    if (part.kind != bit::PartKind::tooth || !wanted(part)) continue;
    for (const Vec3& x_P : part.mesh_P.positions)
      if (const double z = (part.X_BP * x_P).z(); z > depth) {
        depth = z;
        best = &g;
      }
  }
  return *best;
}

/// The triangles of a tooth, and the directions of the rock at its facets.
void add_tooth(const simulation::Case& c, const rock::CuttingGroup& g, const char* name,
               Json& rows) {
  const Pose still;
  const rock::GroupMotion motion = group_motion(g, still, still);
  const mesh::TriangleMesh& m = c.bit.parts[static_cast<std::size_t>(g.parts.front().part)].mesh_P;
  for (const mesh::Triangle& t : m.triangles) {
    const Json at = corners(g.X_BP, m, t);
    Vec3 middle = Vec3::Zero();
    for (const int v : t) middle += (g.X_BP * m.positions[static_cast<std::size_t>(v)]) / 3.0;
    rows.push_back({{"tooth", name},
                    {"corners", at},
                    {"place", list(middle)},
                    {"direction", list(mapped_direction_W(g, motion, middle))}});
  }
}

TEST(RockFigures, show_directions_at_teeth) {
  const simulation::Case c = rock_case("bit-r-steady", {});
  rock::CuttingBit bit = rock::prepare_cutting_bit(c.bit);
  const std::vector<double> still(c.bit.cones.size(), 0.0);
  rock::turn_cones(bit, c.bit, still, still);
  Json rows = Json::array();
  add_tooth(c, deepest_tooth(c, bit, [](const bit::Part& p) { return p.core_P.has_value(); }),
            "gage row", rows);
  add_tooth(c, deepest_tooth(c, bit, [](const bit::Part& p) { return !p.core_P; }), "inner row",
            rows);
  battery::record_table("tooth-directions", rows);
}

/// Every plane of a cutter's outline as a line of the strip (tau, t) of one vertex, and its exit.
TEST(RockFigures, show_the_search_for_an_exit) {
  rock::CuttingPart part;
  part.solid_P = mesh::convex_solid(battery::cylinder(8e-3, 8e-3, 16)).value();
  const rock::RelativePath path{{-1e-3, -5e-3, 1e-3}, {1e-3, 3.5e-3, -1e-3}, {1, 0, 0}, {1, 0, 0}};
  rock::SweptScratch scratch;
  const double exit = rock::exit_distance(part, path, scratch).value();
  rock::PlaneStrip strip;
  const rock::Interval inside = put_path_on_strip(part.solid_P, path, 0.0, strip);
  put_direction_on_strip(part.solid_P, path, strip);
  Json rows = Json::array();
  double highest = 0.0;
  constexpr int samples = 200;
  for (int k = 0; k <= samples; ++k) {
    const rock::Crossing x = leave_at(strip, static_cast<double>(k) / samples);
    if (enter_at(strip, x.tau).t > x.t) continue;
    highest = std::max(highest, x.t);
    rows.push_back({{"what", "level"}, {"tau", x.tau}, {"t", x.t}, {"plane", x.plane}});
  }
  for (std::size_t i = 0; i < strip.columns; ++i)
    rows.push_back({{"what", "plane"},
                    {"rest", strip.rest[i]},
                    {"along", strip.along[i]},
                    {"up", strip.up[i]}});
  rows.push_back({{"what", "exit"}, {"t", exit}, {"from", inside.lo}, {"to", inside.hi}});
  EXPECT_GE(exit, highest);
  EXPECT_NEAR(exit, highest, 1.7e-6);
  battery::record_table("search", rows);
}

}  // namespace tdbd::claims::rock_update_figures_test
