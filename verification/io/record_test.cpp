#include "io/record.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "verification/bit/files/mesh_bit.hpp"

namespace tdbd::row_log_test {

using bit::test_folder;

using Rows = std::vector<std::vector<double>>;

Rows replayed(RowLog& log) {
  Rows rows;
  log.replay([&](std::span<const double> row) { rows.emplace_back(row.begin(), row.end()); });
  return rows;
}

void append(RowLog& log, const Rows& rows) {
  for (const std::vector<double>& row : rows) log.append(row);
}

/// Rows after a checkpoint are made again; what a kill left of one is overwritten.
TEST(RowLog, continues_after_the_rows_that_are_kept) {
  const auto path = test_folder() / "history.rows";
  RowLog first(path, 2, 0);
  append(first, {{1, 2}, {3, 4}, {5, 6}});
  first.sync();
  std::ofstream(path, std::ios::app | std::ios::binary) << "torn";
  RowLog second(path, 2, 2);
  EXPECT_EQ(replayed(second), (Rows{{1, 2}, {3, 4}}));
  append(second, {{7, 8}});
  second.sync();
  EXPECT_EQ(second.rows(), 3);
  RowLog third(path, 2, 3);
  EXPECT_EQ(replayed(third), (Rows{{1, 2}, {3, 4}, {7, 8}}));
}

TEST(RowLog, restarts_with_no_rows) {
  const auto path = test_folder() / "history.rows";
  std::ofstream(path) << "what was there";
  RowLog log(path, 3, 0);
  EXPECT_TRUE(replayed(log).empty());
}

TEST(RowLog, rejects_to_keep_rows_that_are_not_there) {
  const auto path = test_folder() / "history.rows";
  {
    RowLog log(path, 2, 0);
    append(log, {{1, 2}});
  }
  EXPECT_THROW(RowLog(path, 2, 2), RunError);
  EXPECT_THROW(RowLog(test_folder() / "missing" / "rows", 2, 0), RunError);
}

}  // namespace tdbd::row_log_test
