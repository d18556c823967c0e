#include "rock/index/near_list.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "rock/index/vertex_grid.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::rock::near_list_test {

const mesh::Box part_P{Vec3(-0.3, -0.1, -0.2), Vec3(0.3, 0.1, 0.2)};
constexpr int most_vertices = 300;

/// Vertices under an index, and the list of what is near a box that moves through them.
struct Indexed {
  VertexGrid grid{{Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.2};
  std::map<int, Vec3> points;
  NearList list;
  NearListMargins margins{*battery::number(0.0, 0.2), *battery::number(0.0, 0.5)};

  Indexed() {
    const int every = *rc::gen::element(2, 30, 2 * most_vertices);
    for (int v = 0; v < most_vertices; v += every) insert(v, *battery::point(1.2));
  }
  void insert(int v, const Vec3& x) {
    points[v] = x;
    grid.insert(v, x);
  }
};

/// The box at both poses, between planes normal to its axes at the first.
Region region_of(const Pose& X_WP0, const Pose& X_WP1) {
  Region r;
  for (std::size_t k = 0; k < 3; ++k) {
    Slab& s = r.slabs[k];
    s = {X_WP0.R.col(static_cast<int>(k)), INFINITY, -INFINITY};
    for (const Pose& X_WP : {X_WP0, X_WP1})
      for (int i = 0; i < 8; ++i) {
        const Vec3 x_W = X_WP * Vec3(i & 1 ? part_P.hi.x() : part_P.lo.x(),
                                     i & 2 ? part_P.hi.y() : part_P.lo.y(),
                                     i & 4 ? part_P.hi.z() : part_P.lo.z());
        s.lo = std::min(s.lo, s.n.dot(x_W));
        s.hi = std::max(s.hi, s.n.dot(x_W));
        r.box.add(x_W);
      }
  }
  return r;
}

void expect_place(const NearList& list, int v, const Vec3& x_W) {
  RC_ASSERT(std::ranges::count(list.v, v) == 1);
  const auto i = static_cast<std::size_t>(std::ranges::find(list.v, v) - list.v.begin());
  const Vec3 place_W = list.origin_W + Vec3(list.x[i], list.y[i], list.z[i]);
  RC_ASSERT((place_W - x_W).norm() < single_slack(list.region_W.box));
}

/// The list has all that is in its region, each once and in its place, and no vertex that is gone:
/// what a list has that is made at this moment.
void check_list(const Indexed& x) {
  for (const auto& [v, p] : x.points)
    if (is_between(x.list.region_W.slabs, p)) expect_place(x.list, v, p);
  for (const int v : x.list.v)
    if (v != no_vertex) {
      RC_ASSERT(std::ranges::count(x.list.v, v) == 1);
      RC_ASSERT(x.points.contains(v));
    }
}

/// What the list offers for a region: all that is there, each once, and nothing unknown.
void check_search(const Indexed& x, const Region& r) {
  std::vector<int> found;
  add_vertices_between(x.list, r, single_slack(x.list.region_W.box), found);
  for (const auto& [v, p] : x.points)
    if (is_between(r.slabs, p)) RC_ASSERT(std::ranges::count(found, v) == 1);
  for (const int v : found) RC_ASSERT(x.points.contains(v));
}

/// The step moves a vertex and updates the list.
void step_moves(Indexed& x, int v, const Vec3& to) {
  const bool knows = x.list.changes == x.grid.changes();
  x.grid.move(v, to, Notify::none);
  x.points[v] = to;
  if (!knows) return;
  VertexChanges change;
  note_place(change, v, to);
  note_changes(x.list, change);
  x.list.changes = x.grid.changes();
}

/// Others insert, move or remove a vertex; only the journal records it.
void others_change(Indexed& x, int v, const Vec3& to) {
  if (!x.points.contains(v)) return x.insert(v, to);
  if (*battery::integer(0, 1) == 0) {
    x.grid.remove(v);
    x.points.erase(v);
    return;
  }
  x.grid.move(v, to);
  x.points[v] = to;
}

void change_something(Indexed& x) {
  const int v = *battery::integer(0, most_vertices - 1);
  const Vec3 to = *battery::point(1.2);
  const bool is_own = *rc::gen::arbitrary<bool>();
  if (is_own && x.points.contains(v)) return step_moves(x, v, to);
  others_change(x, v, to);
}

RC_GTEST_PROP(NearList, contains_what_a_new_one_would_after_any_changes, ()) {
  Indexed x;
  Pose X_WP = *battery::pose(0.5);
  const Pose step{rotation::exp(*battery::number(0.0, 0.2) * *battery::direction()),
                  *battery::number(0.0, 0.1) * *battery::direction()};
  for (int k = 0; k < 12; ++k) {
    const Pose next = *battery::integer(0, 5) == 0 ? *battery::pose(0.5) : X_WP * step;
    const Region r = region_of(X_WP, next);
    update_near_list(x.grid, {part_P, X_WP, next, r}, x.margins, x.list);
    RC_ASSERT(covers(x.list, x.grid, r));
    check_list(x);
    check_search(x, r);
    for (int n = *battery::integer(0, 40); n > 0; --n) change_something(x);
    X_WP = next;
  }
}

/// Two vertices in a box at rest, and the list of what is there.
struct AtRest {
  VertexGrid grid{{Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.2};
  NearList list;

  AtRest() {
    grid.insert(0, Vec3(0.1, 0.0, 0.0));
    grid.insert(1, Vec3(-0.1, 0.0, 0.0));
    find();
  }
  /// What the list has near the origin, sorted.
  std::vector<int> find() {
    const Pose X_WP{Mat3::Identity(), Vec3::Zero()};
    const Region r = region_of(X_WP, X_WP);
    update_near_list(grid, {part_P, X_WP, X_WP, r}, {}, list);
    std::vector<int> found;
    add_vertices_between(list, r, 0.0, found);
    std::ranges::sort(found);
    return found;
  }
};

TEST(NearList, never_offers_a_removed_vertex_and_follows_its_reused_number) {
  AtRest x;
  EXPECT_EQ(x.find(), (std::vector{0, 1}));
  x.grid.remove(0);
  EXPECT_EQ(x.find(), std::vector{1});
  x.grid.insert(0, Vec3(0.9, 0.0, 0.0));
  EXPECT_EQ(x.find(), std::vector{1});
  x.grid.remove(0);
  x.grid.insert(0, Vec3(0.2, 0.05, 0.0));
  EXPECT_EQ(x.find(), (std::vector{0, 1}));
}

/// A vertex that the step moved out of the list's region is still in the list, at its old place.
TEST(NearList, drops_a_vertex_that_was_removed_after_it_had_left) {
  AtRest x;
  x.grid.move(0, Vec3(0.9, 0.0, 0.0), Notify::none);
  x.list.changes = x.grid.changes();
  x.grid.remove(0);
  EXPECT_EQ(x.find(), std::vector{1});
}

/// A part at rest where rock is edited for long.
TEST(NearList, stays_bounded_while_vertices_come_and_go) {
  AtRest x;
  for (int k = 0; k < 1000; ++k) {
    x.grid.insert(2, Vec3(0.0, 0.05, 1e-4 * k));
    EXPECT_EQ(x.find().size(), 3);
    x.grid.remove(2);
    EXPECT_EQ(x.find().size(), 2);
    ASSERT_LE(x.list.v.size(), 100);
  }
}

/// If the step moves vertices without updating a list, the list is out of date and built again.
TEST(NearList, is_rebuilt_after_an_unreported_move) {
  AtRest x;
  x.grid.insert(2, Vec3::Zero());
  x.grid.move(0, Vec3(0.05, 0.05, 0.0), Notify::none);
  EXPECT_EQ(x.find(), (std::vector{0, 1, 2}));
  EXPECT_EQ(x.list.changes, x.grid.changes());
}

/// How often a list is made in some steps of a steady turn, while others change a vertex every so
/// many steps.
int times_made(int steps, int change_every) {
  VertexGrid grid({Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.2);
  grid.insert(0, Vec3::Zero());
  NearList list;
  const Pose step{rotation::exp(Vec3(0.0, 0.0, 0.01)), Vec3(0.0, 0.0, 0.001)};
  Pose X_WP{Mat3::Identity(), Vec3(0.8, 0.0, 0.0)};
  int made = 0;
  constexpr int warm = 60;
  for (int k = 0; k < warm + steps; ++k) {
    if (change_every > 0 && k % change_every == 0) grid.move(0, Vec3::Zero());
    const Vec3 before = list.origin_W;
    const Pose next = X_WP * step;
    update_near_list(grid, {part_P, X_WP, next, region_of(X_WP, next)}, {}, list);
    if (k >= warm && before != list.origin_W) ++made;
    X_WP = next;
  }
  return made;
}

/// After some steps the index is queried once in eight, whatever others change meanwhile.
TEST(NearList, is_made_once_in_several_steps) {
  EXPECT_LE(times_made(80, 0), 10);
  EXPECT_EQ(times_made(80, 5), times_made(80, 0));
}

VertexGrid some_grid() { return {{Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.2}; }

TEST(ChangeJournal, lists_moved_and_removed_vertices_in_order) {
  VertexGrid grid = some_grid();
  grid.insert(3, Vec3(0.5, 0.0, 0.0));
  grid.move(3, Vec3(0.25, 0.5, -0.5));
  grid.remove(3);
  const VertexChanges& j = grid.journal().changes;
  ASSERT_EQ(j.v, (std::vector{3, 3, 3}));
  EXPECT_EQ(j.x[0], 0.5F);
  EXPECT_EQ(j.x[1], 0.25F);
  EXPECT_EQ(j.y[1], 0.5F);
  EXPECT_EQ(j.z[1], -0.5F);
  EXPECT_TRUE(std::isnan(j.x[2]));
  EXPECT_EQ(grid.changes(), 3);
}

/// Every change counts once, also a move from cell to cell.
TEST(ChangeJournal, drops_entries_before_a_reported_change) {
  VertexGrid grid = some_grid();
  grid.insert(3, Vec3::Zero());
  grid.move(3, Vec3::Constant(0.5), Notify::none);
  EXPECT_TRUE(grid.journal().changes.v.empty());
  EXPECT_EQ(grid.journal().first, 2);
  grid.move(3, Vec3::Constant(-0.5));
  EXPECT_EQ(grid.journal().changes.v, std::vector{3});
  EXPECT_EQ(grid.journal().first, 2);
  EXPECT_EQ(grid.changes(), 3);
}

/// No step comes: nothing else ends the journal.
TEST(ChangeJournal, stays_bounded_however_much_changes) {
  VertexGrid grid = some_grid();
  grid.insert(3, Vec3::Zero());
  constexpr int changes = 10 * static_cast<int>(ChangeJournal::most);
  for (int k = 0; k < changes; ++k) {
    grid.move(3, Vec3::Constant(1e-4 * k));
    ASSERT_LE(grid.journal().changes.v.size(), ChangeJournal::most);
    ASSERT_LT(grid.journal().changes.x.size(), ChangeJournal::most + 8);
  }
  EXPECT_EQ(grid.changes(), 1 + changes);
  EXPECT_EQ(grid.journal().changes.v.capacity(), ChangeJournal::most);
}

TEST(ChangeJournal, passes_over_what_is_put_into_an_empty_index_at_once) {
  VertexGrid grid = some_grid();
  grid.insert_all({Vec3::Zero(), Vec3::Constant(0.5)}, {0, 1});
  EXPECT_EQ(grid.changes(), 2);
  EXPECT_TRUE(grid.journal().changes.v.empty());
}

}  // namespace tdbd::rock::near_list_test
