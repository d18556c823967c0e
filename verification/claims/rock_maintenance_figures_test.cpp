#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "claims/example_bits.hpp"
#include "mesh/check/check.hpp"
#include "mesh/edit.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/maintain/operations.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

/// Tables that figures of section 4.2 are drawn of: what maintenance did to small sheets of rock
/// (reports/figures).
namespace tdbd::claims::rock_maintenance_figures_test {

using Json = nlohmann::ordered_json;

constexpr double half = 1.0, bump = 0.35;
constexpr int cells = 6;

rock::Rock sheet(std::uint64_t seed, double wildness = bump) {
  constexpr double cell = 2.0 * half / cells;
  return rock::make_rock(mesh::make_surface(battery::bumpy_rock(half, cells, wildness, seed)),
                         2.0 * cell, {Vec3::Constant(-half), Vec3::Constant(half)});
}

Json list(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

Json stage(const std::string& name, const mesh::Surface& s) {
  const mesh::TriangleMesh m = mesh::compact(s);
  Json positions = Json::array(), triangles = Json::array();
  for (const Vec3& x : m.positions) positions.push_back(list(x));
  for (const mesh::Triangle& t : m.triangles) triangles.push_back({t[0], t[1], t[2]});
  return {{"stage", name}, {"positions", positions}, {"triangles", triangles}};
}

struct Edge {
  int a, b;
  double length;
};

/// Edges between inner vertices, shortest first.
std::vector<Edge> inner_edges(const mesh::Surface& s) {
  std::vector<Edge> edges;
  edges.reserve(s.triangles.size());
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (!s.triangle_is_alive(c / 3) || s.opposite_of(c) < c) continue;
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    if (!s.is_boundary(a) && !s.is_boundary(b))
      edges.push_back({a, b, (s.position(a) - s.position(b)).norm()});
  }
  std::ranges::sort(edges, {}, &Edge::length);
  return edges;
}

void mark(Json& row, const mesh::Surface& s, const Edge& e) {
  row["edge"] = {list(s.position(e.a)), list(s.position(e.b))};
}

rock::MaintenanceLimits limits() { return rock::bare_limits_for(2.0 * half / cells); }

TEST(RockFigures, show_the_collapse_of_an_edge) {
  const rock::Rock before = sheet(5);
  for (const Edge& e : inner_edges(before.surface)) {
    const rock::CollapseVerdict verdict = judge_collapse(before.surface, e.a, e.b, limits());
    if (!is_accepted(verdict)) continue;
    mesh::Surface after = before.surface;
    mesh::collapse_edge(after, verdict.corner, verdict.x_W);
    EXPECT_EQ(after.triangle_count(), before.surface.triangle_count() - 2);
    Json rows = {stage("before", before.surface), stage("after", after)};
    mark(rows[0], before.surface, e);
    rows[1]["place"] = list(verdict.x_W);
    battery::record_table("collapse", rows);
    return;
  }
  FAIL() << "no edge may collapse";
}

/// All long edges bisected, longest first; `touch` selects the whole sheet.
rock::Rock bisected(rock::Rock sheet, double longest) {
  rock::MaintenanceLimits l = limits();
  l.shortest_edge = l.worst_quality = 0.0;
  l.longest_edge = longest;
  for (int v = 0; v < sheet.surface.vertex_slots(); ++v) touch(sheet, v);
  rock::MaintenanceWorkspace work;
  rock::MaintenanceReport report;
  maintain(sheet, l, work, report);
  return sheet;
}

TEST(RockFigures, show_bisection) {
  const rock::Rock before = sheet(5);
  const std::vector<Edge> edges = inner_edges(before.surface);
  const rock::Rock first = bisected(before, edges.back().length * 0.999);
  const rock::Rock all = bisected(before, 0.75 * edges.back().length);
  EXPECT_EQ(first.surface.triangle_count(), before.surface.triangle_count() + 2);
  EXPECT_NEAR(mesh::hole_volume(all.surface, Vec3::Zero()),
              mesh::hole_volume(before.surface, Vec3::Zero()), 1e-14);
  Json rows = {stage("before", before.surface), stage("the longest edge bisected", first.surface),
               stage("all edges above 0.75 of it", all.surface)};
  mark(rows[0], before.surface, edges.back());
  battery::record_table("bisection", rows);
}

/// Whether a surface is still an oriented disc in itself.
bool is_sound(const mesh::Surface& s) {
  std::vector<mesh::Defect> defects = mesh::check_surface(mesh::compact(s));
  std::erase_if(defects, [](const mesh::Defect& d) {
    return d.kind == mesh::Defect::Kind::degenerate_triangle;
  });
  return defects.empty() && mesh::adjacency_is_consistent(s);
}

/// What the guards say of every edge of random sheets under random limits.
struct Asked {
  long accepted = 0, refused = 0, unsound = 0;
  std::set<std::string> reasons;
  Json examples = Json::array();

  void ask(const mesh::Surface& s, const Edge& e, const rock::MaintenanceLimits& l) {
    const rock::CollapseVerdict verdict = judge_collapse(s, e.a, e.b, l);
    if (is_accepted(verdict)) {
      mesh::Surface after = s;
      mesh::collapse_edge(after, verdict.corner, verdict.x_W);
      ++accepted;
      unsound += !is_sound(after);
    } else if (verdict.refused) {
      ++refused;
      note(s, e, rock::refusal_names[static_cast<std::size_t>(*verdict.refused)]);
    }
  }
  /// Keeps the first sheet for each reason.
  void note(const mesh::Surface& s, const Edge& e, const std::string& reason) {
    if (!reasons.insert(reason).second) return;
    Json row = stage(reason, s);
    mark(row, s, e);
    examples.push_back(row);
  }
};

/// Edges to the boundary too, which inner_edges leaves out.
std::vector<Edge> all_edges(const mesh::Surface& s) {
  std::vector<Edge> edges = inner_edges(s);
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    if (s.is_boundary(a) != s.is_boundary(b)) {
      edges.push_back({a, b, 0.0});
      break;
    }
  }
  return edges;
}

TEST(RockFigures, show_what_cannot_be_deleted) {
  Asked asked;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    // Collapses first make valences small, so that the topology refuses some.
    mesh::Surface s = sheet(seed, 0.2 + 0.01 * static_cast<double>(seed)).surface;
    rock::MaintenanceLimits l = limits();
    l.longest_edge *= 1.0 + 0.1 * static_cast<double>(seed % 7);
    for (int k = 0; k < 25; ++k) {
      const std::vector<Edge> edges = all_edges(s);
      for (const Edge& e : edges) asked.ask(s, e, l);
      const auto next = std::ranges::find_if(edges, [&](const Edge& e) {
        const int c = mesh::corner_facing(s, e.a, e.b);
        return !s.is_boundary(e.a) && !s.is_boundary(e.b) && c >= 0 &&
               mesh::collapse_keeps_topology(s, c);
      });
      if (next == edges.end()) break;
      mesh::collapse_edge(s, mesh::corner_facing(s, next->a, next->b),
                          0.5 * (s.position(next->a) + s.position(next->b)));
    }
  }
  EXPECT_GT(asked.accepted, 100);
  EXPECT_TRUE(asked.reasons.contains("topology"));
  EXPECT_TRUE(asked.reasons.contains("boundary"));
  EXPECT_TRUE(asked.reasons.contains("normal"));
  fmt::print("{} accepted, {} refused\n", asked.accepted, asked.refused);
  record_bound("chapter4/guards",
               "collapses that the guards accept on random sheets: surfaces torn or pinched",
               static_cast<double>(asked.unsound), "1", 0.0);
  battery::record_table("refusals", asked.examples);
}

Vec3 mean_of_neighbours(const mesh::Surface& s, int v) {
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  mesh::visit_corners(s, v, [&](int c) {
    sum += s.position(s.vertex(mesh::next_corner(c)));
    count += 1.0;
  });
  return sum / count;
}

/// A vertex that went elsewhere, and the volume that this changed over the cube of a cell.
struct Moved {
  mesh::Surface surface;
  double volume;
};

Moved moved(const mesh::Surface& s, int v, const Vec3& x_W) {
  constexpr double cell = 2.0 * half / cells;
  Moved m{s, 0.0};
  m.surface.place(v, x_W);
  m.volume =
      std::abs(mesh::hole_volume(m.surface, s.position(v)) - mesh::hole_volume(s, s.position(v))) /
      (cell * cell * cell);
  return m;
}

/// Of all vertices that may be smoothed: what moving them to the mean of their neighbours changes,
/// and what our move does. The figure shows the one that plain smoothing changes most.
TEST(RockFigures, show_smoothing) {
  double plain_most = 0.0, ours_most = 0.0;
  Json rows;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const mesh::Surface s = sheet(seed).surface;
    for (int v = 0; v < s.vertex_slots(); ++v) {
      const rock::SmoothVerdict verdict = judge_smooth(s, v, limits());
      if (verdict.refused) continue;
      const Moved plain = moved(s, v, mean_of_neighbours(s, v)), ours = moved(s, v, verdict.x_W);
      ours_most = std::max(ours_most, ours.volume);
      if (plain.volume <= plain_most) continue;
      plain_most = plain.volume;
      rows = {stage("before", s),
              stage(fmt::format("mean of neighbours, {:.2f} h^3", plain.volume), plain.surface),
              stage(fmt::format("without its normal part, {:.0e} h^3", ours.volume), ours.surface)};
    }
  }
  record_bound("chapter4/smoothing",
               "random sheets: most volume that smoothing a vertex changes, over h^3", ours_most,
               "1", 1e-12);
  constexpr double much = 0.05;
  EXPECT_GE(plain_most, much);
  battery::record({"chapter4/smoothing",
                   "the same vertices to the mean of their neighbours: most volume, over h^3",
                   plain_most, "1", ">= 0.05", battery::Verdict::holds});
  battery::record_table("smoothing", rows);
}

}  // namespace tdbd::claims::rock_maintenance_figures_test
