#include "core/config/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/text.hpp"

namespace tdbd {
namespace {

/// "50,5" as "50.5"; other cells are unchanged.
std::string with_decimal_point(const std::string& cell) {
  const std::size_t comma = cell.find(',');
  if (comma == std::string::npos) return cell;
  std::string other = cell;
  other[comma] = '.';
  return csv_number<double>(other) ? other : cell;
}

/// Spreadsheet programs also write workbooks. Zero bytes are UTF-16 without a byte-order mark, or no
/// text.
void require_no_workbook(const std::string& path, std::string_view text) {
  if (text.starts_with("PK\x03\x04") || text.starts_with("\xD0\xCF\x11\xE0"))
    refuse_table(
        path, 1, "table", "a workbook of a spreadsheet program",
        "a CSV table: save the sheet as \"CSV UTF-8\" (Excel: File, Save As; LibreOffice: File, "
        "Save As, Text CSV)");
  const bool utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (!utf16 && text.find('\0') != std::string_view::npos)
    refuse_table(path, 1, "table", "a zero byte", "text: save the sheet as \"CSV UTF-8\"");
}

/// The separator that is most frequent in a line, outside quotes.
char separator_of(std::string_view line) {
  std::map<char, int> times;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted) ++times[c];
  }
  char best = ',';
  for (const char c : {';', '\t'})
    if (times[c] > times[best]) best = c;
  return best;
}

/// Reads the records of a text. RFC 4180: a cell in quotes may contain separators, line ends and,
/// doubled, quotes.
class CsvScanner {
 public:
  CsvScanner(const std::string& path, std::string_view text) : path_(path), text_(text) {}

  std::vector<CsvRow> rows() {
    std::vector<CsvRow> rows;
    bool first = true;
    while (at_ < text_.size()) {
      const std::string_view line = trimmed(rest_of_line());
      if (line.empty() || line.front() == '#') {
        skip_line();
      } else if (first && lower_case(line).starts_with("sep=")) {
        separator_ = line.size() > 4 ? line[4] : '\t';  // the blank at the end was trimmed
        skip_line();
      } else {
        if (!separator_) separator_ = separator_of(line);
        if (CsvRow row = take_row(); !is_blank(row)) rows.push_back(std::move(row));
      }
      first = false;
    }
    return rows;
  }

  bool has_decimal_commas() const { return separator_ && separator_ != ','; }

 private:
  static bool is_blank(const CsvRow& row) {
    return std::ranges::all_of(row.cells, [](const std::string& c) { return c.empty(); });
  }

  bool at_line_end() const {
    return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r';
  }

  std::string_view rest_of_line() const {
    return text_.substr(at_, std::min(text_.find_first_of("\r\n", at_), text_.size()) - at_);
  }

  /// Lines end with LF, CRLF, or CR as on old Macintosh systems.
  void take_line_end() {
    if (at_ == text_.size()) return;
    at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
    ++line_;
  }

  void skip_line() {
    at_ += rest_of_line().size();
    take_line_end();
  }

  CsvRow take_row() {
    CsvRow row{line_, {}};
    while (true) {
      row.cells.push_back(take_cell(row.line, row.cells.size() + 1));
      if (at_line_end()) break;
      ++at_;  // the separator
    }
    take_line_end();
    return row;
  }

  /// The text up to the next separator or line end.
  std::string_view take_plain() {
    const std::size_t from = at_;
    while (!at_line_end() && text_[at_] != separator_) ++at_;
    return trimmed(text_.substr(from, at_ - from));
  }

  std::string take_cell(long line, std::size_t column) {
    while (!at_line_end() && text_[at_] == ' ') ++at_;
    if (at_line_end() || text_[at_] != '"') return std::string(take_plain());
    std::string cell;
    ++at_;
    while (true) {
      if (at_ == text_.size())
        refuse_table(path_, line, fmt::format("cell {}", column), "a quote that is never closed",
                     "a second quote at the end of the cell");
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c == '"' && !text_.substr(at_).starts_with('"')) break;
      if (c == '"') ++at_;
      cell += c;
    }
    if (const std::string_view after = take_plain(); !after.empty())
      refuse_table(path_, line, fmt::format("cell {}", column),
                   fmt::format("\"{}\" after the closing quote", after),
                   "a separator; a quote inside quotes is doubled");
    return std::string(trimmed(cell));
  }

  const std::string& path_;
  std::string_view text_;
  std::size_t at_ = 0;
  long line_ = 1;
  std::optional<char> separator_;
};

/// Removes empty cells beyond the last named column: spreadsheet programs end rows with separators.
void drop_empty_columns(std::vector<CsvRow>& rows) {
  if (rows.empty()) return;
  std::vector<std::string>& header = rows.front().cells;
  while (!header.empty() && header.back().empty()) header.pop_back();
  for (CsvRow& row : rows)
    while (row.cells.size() > header.size() && row.cells.back().empty()) row.cells.pop_back();
}

/// Whether a file separated by commas has decimal commas inside quotes, as in "19,5": then a number
/// has other than three digits behind its comma.
bool has_quoted_decimals(const std::vector<CsvRow>& rows) {
  constexpr std::size_t group = 3;
  for (const CsvRow& row : rows)
    for (const std::string& cell : row.cells)
      if (with_decimal_point(cell) != cell && cell.size() - cell.find(',') - 1 != group)
        return true;
  return false;
}

/// Replaces decimal commas by points. A file that has both may use commas for thousands.
void replace_decimal_commas(const std::string& path, std::vector<CsvRow>& rows) {
  const CsvRow *with_comma = nullptr, *with_point = nullptr;
  std::string comma, point;
  for (CsvRow& row : rows)
    for (std::string& cell : row.cells) {
      const bool is_number = csv_number<double>(cell).has_value();
      if (is_number && cell.find('.') != std::string::npos && !with_point) {
        with_point = &row;
        point = cell;
      }
      std::string other = with_decimal_point(cell);
      if (other == cell) continue;
      if (!with_comma) comma = cell;
      if (!with_comma) with_comma = &row;
      cell = std::move(other);
    }
  if (with_comma && with_point)
    refuse_table(
        path, with_comma->line, "numbers",
        fmt::format("a comma in \"{}\" and a point in \"{}\" of line {}", comma, point,
                    with_point->line),
        "either decimal commas or decimal points in all numbers, and no separators of thousands");
}

void check_header(const CsvRow& row, CsvMistakes& mistakes) {
  std::map<std::string_view, int> times;
  for (const std::string& name : row.cells) ++times[name];
  for (const std::string& name : row.cells) {
    if (name.empty() || csv_number<double>(name))
      mistakes.add(row.line, "header", fmt::format("\"{}\"", name), "the name of a column");
    if (times[name] > 1)
      mistakes.add(row.line, "header", fmt::format("\"{}\" twice", name), "different names");
  }
}

void add_row(CsvTable& table, const CsvRow& text, CsvMistakes& mistakes) {
  if (text.cells.size() != table.header.size()) {
    mistakes.add(text.line, "row", fmt::format("{} values", text.cells.size()),
                 fmt::format("{}, as in the header", table.header.size()));
    return;
  }
  std::vector<double> row;
  for (std::size_t i = 0; i < text.cells.size(); ++i) {
    const std::optional<double> value = csv_number<double>(text.cells[i]);
    if (!value)
      mistakes.add(text.line, table.header[i], fmt::format("\"{}\"", text.cells[i]),
                   "a finite number" + comma_hint(text.cells[i]));
    row.push_back(value.value_or(0.0));
  }
  table.rows.push_back(std::move(row));
  table.lines.push_back(text.line);
}

}  // namespace

std::string comma_hint(std::string_view cell) {
  if (cell.find(',') == std::string_view::npos) return "";
  return cell.find('.') == std::string_view::npos
             ? " (a decimal comma needs columns separated by semicolons or tabs)"
             : " without separators of thousands";
}

NamedUnit split_unit(std::string_view text) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
    const std::size_t from = text.rfind(open);
    if (text.empty() || text.back() != close || from == std::string_view::npos) continue;
    return {std::string(trimmed(text.substr(0, from))),
            std::string(trimmed(text.substr(from + 1, text.size() - from - 2)))};
  }
  return {std::string(text), ""};
}

std::vector<CsvRow> read_csv_rows(const std::string& path) {
  require_no_workbook(path, read_file(path, "a CSV table"));
  const std::string text = read_text_file(path, "a CSV table", ": save the sheet as \"CSV UTF-8\"");
  CsvScanner scanner(path, text);
  std::vector<CsvRow> rows = scanner.rows();
  drop_empty_columns(rows);
  if (scanner.has_decimal_commas() || has_quoted_decimals(rows)) replace_decimal_commas(path, rows);
  return rows;
}

void CsvMistakes::add(long line, std::string_view column, std::string_view found,
                      std::string_view expected) {
  lines.push_back(
      fmt::format("{}:{}: {}: found {}, expected {}", file, line, column, found, expected));
}

void CsvMistakes::throw_if_any() const {
  constexpr std::size_t most = 40;
  if (lines.empty()) return;
  const std::size_t listed = std::min(most, lines.size());
  std::string text =
      fmt::format("{}", fmt::join(lines.begin(), lines.begin() + static_cast<long>(listed), "\n"));
  if (listed < lines.size())
    text += fmt::format("\n{}: found {} more mistakes, expected none", file, lines.size() - listed);
  throw InputError(text);
}

void refuse_table(const std::string& file, long line, std::string_view what, std::string_view found,
                  std::string_view expected) {
  CsvMistakes mistakes{file};
  mistakes.add(line, what, found, expected);
  throw InputError(mistakes.lines.front());
}

CsvTable read_csv(const std::string& path) {
  CsvTable table{path, {}, {}, {}};
  CsvMistakes mistakes{path};
  for (const CsvRow& row : read_csv_rows(path)) {
    if (!table.header.empty()) {
      add_row(table, row, mistakes);
      continue;
    }
    check_header(row, mistakes);
    table.header = row.cells;
  }
  if (table.header.empty()) mistakes.add(1, "header", "nothing", "the names of the columns");
  mistakes.throw_if_any();
  return table;
}

std::size_t csv_column(const CsvTable& table, std::string_view name) {
  const auto place = std::find(table.header.begin(), table.header.end(), name);
  if (place != table.header.end()) return static_cast<std::size_t>(place - table.header.begin());
  for (std::size_t i = 0; i < table.header.size(); ++i)
    if (lower_case(table.header[i]) == lower_case(name)) return i;
  const auto near = nearest_name(name, table.header);
  const std::string found = near ? fmt::format("the column {}", *near) : "no such column";
  throw InputError(
      fmt::format("{}: {}: found {}, expected a column of this name", table.file, name, found));
}

}  // namespace tdbd
