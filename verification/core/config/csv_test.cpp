#include "core/config/csv.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::csv_test {

std::string failure(const std::string& path) {
  try {
    read_csv(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CsvRows, keep_empty_cells_and_trim_the_others) {
  const auto rows = read_csv_rows(write_temporary(".csv", "a, b ,,\td\n,x,\n"));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].cells, (std::vector<std::string>{"a", "b", "", "d"}));
  EXPECT_EQ(rows[1].cells, (std::vector<std::string>{"", "x", ""}));
}

TEST(CsvRows, count_the_lines_that_they_skip) {
  const auto rows = read_csv_rows(write_temporary(".csv", "# note\r\n\n  \na\n"));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].line, 4);
}

TEST(CsvRows, include_a_last_line_without_its_end) {
  EXPECT_EQ(read_csv_rows(write_temporary(".csv", "a\nb")).size(), 2u);
}

TEST(CsvRows, of_a_missing_file_are_an_error) {
  EXPECT_THROW(read_csv_rows("/no/such.csv"), InputError);
}

TEST(CsvRows, have_the_separator_of_the_header) {
  const auto semicolons = read_csv_rows(write_temporary(".csv", "a;b\n1,5;2.5\n;\n1,5,2;x,y\n"));
  ASSERT_EQ(semicolons.size(), 3u);
  EXPECT_EQ(semicolons[1].cells, (std::vector<std::string>{"1.5", "2.5"}));
  EXPECT_EQ(semicolons[2].cells, (std::vector<std::string>{"1,5,2", "x,y"}));
  const auto tabs = read_csv_rows(write_temporary("_tabs.csv", "a\tb\tc\n1,5\t\t\n"));
  ASSERT_EQ(tabs.size(), 2u);
  EXPECT_EQ(tabs[1].cells, (std::vector<std::string>{"1.5", "", ""}));
}

TEST(CsvRows, take_quoted_cells) {
  const auto rows = read_csv_rows(write_temporary(".csv", "a,b\n\"x, \"\"y\"\"\" , 2\n\"open,3\n"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].cells, (std::vector<std::string>{"x, \"y\"", "2"}));
  EXPECT_EQ(rows[2].cells, (std::vector<std::string>{"open,3"}));
}

TEST(CsvRows, reject_what_spreadsheet_programs_write_besides) {
  const std::string utf16 = write_temporary(".csv",
                                            "\xff\xfe"
                                            "a");
  EXPECT_EQ(failure(utf16), utf16 +
                                ":1: table: found text in UTF-16, expected UTF-8: save the sheet "
                                "as \"CSV UTF-8\"");
}

TEST(Csv, reads_numbers_under_a_header) {
  const CsvTable table = read_csv(
      write_temporary(".csv", "\xef\xbb\xbf# path\r\n t , x\r\n\r\n0, -1.5e-3\r\n1,2\r\n"));
  EXPECT_EQ(table.header, (std::vector<std::string>{"t", "x"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0, -1.5e-3}, {1, 2}}));
  EXPECT_EQ(table.lines, (std::vector<long>{4, 5}));
  EXPECT_EQ(csv_column(table, "x"), 1u);
}

TEST(Csv, reports_all_mistakes_with_line_and_column) {
  const std::string path = write_temporary(".csv", "t,x\n0,nan\n1\n2,1e3m\n,inf\n");
  std::string expected =
      "FILE:2: x: found \"nan\", expected a finite number\n"
      "FILE:3: row: found 1 values, expected 2, as in the header\n"
      "FILE:4: x: found \"1e3m\", expected a finite number\n"
      "FILE:5: t: found \"\", expected a finite number\n"
      "FILE:5: x: found \"inf\", expected a finite number";
  for (std::size_t at = 0; (at = expected.find("FILE", at)) != std::string::npos;)
    expected.replace(at, 4, path);
  EXPECT_EQ(failure(path), expected);
}

TEST(Csv, rejects_a_bad_header) {
  const std::string twice = write_temporary("_twice.csv", "t,t\n");
  EXPECT_EQ(failure(twice).rfind(twice + ":1: header: found \"t\" twice, expected different", 0),
            0u);
  const std::string numbers = write_temporary("_numbers.csv", "0,1\n");
  EXPECT_EQ(failure(numbers).rfind(numbers + ":1: header: found \"0\", expected the name", 0), 0u);
  const std::string empty = write_temporary("_empty.csv", "# nothing\n");
  EXPECT_EQ(failure(empty), empty + ":1: header: found nothing, expected the names of the columns");
}

TEST(Csv, rejects_a_missing_file_and_a_missing_column) {
  EXPECT_EQ(failure("/no/such.csv"), "/no/such.csv: found no such file, expected a CSV table");
  EXPECT_NE(failure(tdbd::temporary_folder()).find("expected a CSV table"), std::string::npos);
  const CsvTable table{"f.csv", {"time", "depth"}, {}, {}};
  try {
    csv_column(table, "dept");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "f.csv: dept: found the column depth, expected a column of this name");
  }
}

RC_GTEST_PROP(Csv, numbers_with_17_digits_come_back, (const std::vector<double>& values)) {
  std::string text = "v\n";
  for (const double v : values) {
    RC_PRE(std::isfinite(v));
    text += fmt::format("{:.17g}\n", v);
  }
  const std::string path = tdbd::temporary_folder() + "csv_numbers.csv";
  std::ofstream(path) << text;
  const CsvTable table = read_csv(path);
  RC_ASSERT(table.rows.size() == values.size());
  for (std::size_t i = 0; i < values.size(); ++i) RC_ASSERT(table.rows[i][0] == values[i]);
}

}  // namespace tdbd::csv_test
