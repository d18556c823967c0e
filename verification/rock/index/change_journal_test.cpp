#include "rock/index/change_journal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock::change_journal_test {

VertexGrid some_grid() { return {{Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.2}; }

TEST(ChangeJournal, says_in_order_where_vertices_came_to_and_which_are_gone) {
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
TEST(ChangeJournal, forgets_what_came_before_a_change_that_its_mover_tells) {
  VertexGrid grid = some_grid();
  grid.insert(3, Vec3::Zero());
  grid.move(3, Vec3::Constant(0.5), Teller::mover);
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

}  // namespace tdbd::rock::change_journal_test
