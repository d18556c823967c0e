#include "bit/cutter/csv.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::bit {
namespace {

std::vector<CsvRow> rows_of(const std::string& text) {
  const std::string path = tdbd::temporary_folder() + "tdbd-" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
  std::ofstream(path) << text;
  const std::vector<CsvRow> rows = read_csv(path);
  std::filesystem::remove(path);
  return rows;
}

TEST(csv, keeps_empty_cells_and_trims_the_others) {
  const auto rows = rows_of("a, b ,,\td\n,x,\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].cells, (std::vector<std::string>{"a", "b", "", "d"}));
  EXPECT_EQ(rows[1].cells, (std::vector<std::string>{"", "x", ""}));
}

TEST(csv, counts_the_lines_that_it_skips) {
  const auto rows = rows_of("# note\r\n\n  \na\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].line, 4);
}

TEST(csv, reads_a_last_line_without_its_end) { EXPECT_EQ(rows_of("a\nb").size(), 2u); }

TEST(csv, of_a_missing_file_is_an_error) {
  EXPECT_THROW(read_csv(tdbd::temporary_folder() + "tdbd-no-such-file.csv"), InputError);
}

}  // namespace
}  // namespace tdbd::bit
