#include "bit/cutter/csv.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace tdbd::bit {
namespace {

std::string trimmed(const std::string& s) {
  const auto first = s.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return s.substr(first, s.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split_cells(const std::string& text) {
  std::vector<std::string> cells;
  std::istringstream in(text);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(trimmed(cell));
  if (text.ends_with(',')) cells.emplace_back();
  return cells;
}

}  // namespace

std::vector<CsvRow> read_csv(const std::string& path) {
  std::ifstream in(path);
  if (!in)
    throw InputError(fmt::format("{}:1: file: found nothing, expected a readable file", path));
  std::vector<CsvRow> rows;
  int line = 0;
  for (std::string raw; std::getline(in, raw);) {
    ++line;
    const std::string text = trimmed(raw);
    if (!text.empty() && text.front() != '#') rows.push_back({line, split_cells(text)});
  }
  return rows;
}

}  // namespace tdbd::bit
