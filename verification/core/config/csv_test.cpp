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
  const auto semicolons = read_csv_rows(write_temporary(".csv", "a;b\n1,5;2,5\n;\n1,5,2;x,y\n"));
  ASSERT_EQ(semicolons.size(), 3u);
  EXPECT_EQ(semicolons[1].cells, (std::vector<std::string>{"1.5", "2.5"}));
  EXPECT_EQ(semicolons[2].cells, (std::vector<std::string>{"1,5,2", "x,y"}));
  const auto tabs = read_csv_rows(write_temporary("_tabs.csv", "a\tb\tc\n1,5\t\t\n"));
  ASSERT_EQ(tabs.size(), 2u);
  EXPECT_EQ(tabs[1].cells, (std::vector<std::string>{"1.5", "", ""}));
}

TEST(CsvRows, take_quoted_cells) {
  const auto rows =
      read_csv_rows(write_temporary(".csv", "a,b\n\"x, \"\"y\"\"\" , 2\n\"1\n2\",3\n4,5\n"));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1].cells, (std::vector<std::string>{"x, \"y\"", "2"}));
  EXPECT_EQ(rows[2].cells, (std::vector<std::string>{"1\n2", "3"}));
  EXPECT_EQ(rows[3].line, 5);  // the cell before spans two lines
}

/// The message about a file with these bytes, without the path.
std::string message_about(const std::string& bytes) {
  const std::string path = write_temporary(".csv", bytes), text = failure(path);
  return text.starts_with(path) ? text.substr(path.size()) : text;
}

TEST(CsvRows, reject_what_is_no_text) {
  EXPECT_EQ(message_about("a,b\n1,2\nx\xE9,3\n"),
            ":3: byte 2 of the line: found 0xE9, expected text in UTF-8: save the sheet as \"CSV "
            "UTF-8\"");
  EXPECT_TRUE(message_about("PK\x03\x04").starts_with(":1: table: found a workbook"));
  EXPECT_TRUE(message_about(std::string("a\0,\0", 4)).starts_with(":1: table: found a zero byte"));
}

TEST(CsvRows, reject_quotes_that_do_not_enclose_a_cell) {
  EXPECT_EQ(message_about("a,b\n1,\"open\n2,3\n"),
            ":2: cell 2: found a quote that is never closed, expected a second quote at the end of "
            "the cell");
  EXPECT_EQ(message_about("a,b\n\"1\"2,3\n"),
            ":2: cell 1: found \"2\" after the closing quote, expected a separator; a quote inside "
            "quotes is doubled");
}

/// One table as spreadsheet programs write it.
TEST(CsvRows, are_the_same_in_all_dialects) {
  const std::vector<std::vector<std::string>> same{{"a", "b"}, {"1.5", "x"}, {"-2", "3.25"}};
  const auto utf16 = [](const std::string& ascii, bool big) {
    std::string bytes = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : ascii) bytes += big ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
  };
  const std::string commas = "a,b\n1.5,x\n-2,3.25\n";
  for (const std::string& bytes :
       {commas, std::string("\xEF\xBB\xBF") + commas, utf16(commas, false), utf16(commas, true),
        std::string("a,b\r\n1.5,x\r\n-2,3.25\r\n"), std::string("a,b\r1.5,x\r-2,3.25"),
        std::string("\"a\",\"b\"\n\"1.5\",\"x\"\n\"-2\",\"3.25\"\n"),
        std::string("sep=;\na;b\n1,5;x\n-2;3,25\n"), std::string("SEP=,\r\na,b\n1.5,x\n-2,3.25\n"),
        std::string("a;b\n1,5;x\n-2;3,25\n"), std::string("a;b\n1.5;x\n-2;3.25\n"),
        std::string("a\tb\n1,5\tx\n-2\t3,25\n"), std::string("a,b\n\"1,5\",x\n-2,\"3,25\"\n"),
        std::string("a,b,\n1.5,x,\n,,\n-2,3.25,\n,,\n"), std::string("a;b;;\n1,5;x;;\n-2;3,25\n"),
        std::string("\n\n# note\na,b\n\n1.5,x\n  \n-2,3.25\n,\n")}) {
    std::vector<std::vector<std::string>> cells;
    for (const CsvRow& row : read_csv_rows(write_temporary(".csv", bytes)))
      cells.push_back(row.cells);
    EXPECT_EQ(cells, same) << bytes;
  }
}

/// In a file with decimal points, a comma may separate thousands: 1,234 is not 1.234.
TEST(CsvRows, reject_decimal_commas_beside_decimal_points) {
  EXPECT_EQ(
      message_about("a;b\n12.5;3\n1,234;2\n"),
      ":3: numbers: found a comma in \"1,234\" and a point in \"12.5\" of line 2, expected "
      "either decimal commas or decimal points in all numbers, and no separators of thousands");
  EXPECT_EQ(message_about("a,b\n\"1,234\",2\n"),
            ":2: a: found \"1,234\", expected a finite number (a decimal comma needs columns "
            "separated by semicolons or tabs)");
}

TEST(Csv, reads_numbers_under_a_header) {
  const CsvTable table = read_csv(
      write_temporary(".csv", "\xef\xbb\xbf# path\r\n t , x\r\n\r\n0, -1.5e-3\r\n1,2\r\n"));
  EXPECT_EQ(table.header, (std::vector<std::string>{"t", "x"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0, -1.5e-3}, {1, 2}}));
  EXPECT_EQ(table.lines, (std::vector<long>{4, 5}));
  EXPECT_EQ(csv_column(table, "x"), 1u);
  EXPECT_EQ(csv_column(table, "X"), 1u);
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
