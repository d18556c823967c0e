#include "bit/cutter/cutter_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/text.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

constexpr double mm = 1e-3;
constexpr double tiny = 1e-6;  ///< lower bound of "positive": more than a nanometre, in mm
constexpr double large = 1e4;  ///< mm: no bit is 10 m wide

struct UnitSuffix {
  std::string_view name;
  double si;
  bool angle;
};
constexpr std::array<UnitSuffix, 6> suffixes{{{"mm", 1e-3, false},
                                              {"cm", 1e-2, false},
                                              {"m", 1.0, false},
                                              {"in", 0.0254, false},
                                              {"deg", degree, true},
                                              {"rad", 1.0, true}}};

struct LabelColumn {
  std::string_view name;
  bool required;
  std::string_view kind, fallback, meaning;
};
constexpr std::array<LabelColumn, 4> labels{
    {{"bit", false, "text", "the bit file's name", "name of the bit; any text"},
     {"cutter", true, "whole number", "required", "number of the cutter, different in every row"},
     {"blade", true, "whole number", "required", "number of its blade"},
     {"zone", true, "text", "required", "label of its region: cone, nose, shoulder, gage"}}};

constexpr std::array<std::string_view, 6> note_columns{"note",     "notes",  "comment",
                                                       "comments", "remark", "remarks"};

/// Names that other programs use, and the column that is probably meant. They are suggested, never
/// accepted, because definitions differ between programs.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> other_names{
    {{"diameter", "dia"},
     {"d", "dia"},
     {"radius", "r_tip"},
     {"r", "r_tip"},
     {"height", "h_tip"},
     {"h", "h_tip"},
     {"z", "h_tip"},
     {"azimuth", "phi"},
     {"angle", "phi"},
     {"theta", "phi"},
     {"backrake", "back_rake"},
     {"br", "back_rake"},
     {"siderake", "side_rake"},
     {"sr", "side_rake"},
     {"id", "cutter"},
     {"number", "cutter"},
     {"no", "cutter"},
     {"region", "zone"},
     {"location", "zone"},
     {"profile", "profile_angle"}}};

/// "R tip [mm]" as "r_tip_mm".
std::string normalized(std::string_view name) {
  std::string n;
  for (const char c : name) {
    const bool separates = c == ' ' || c == '-' || c == '[' || c == '(' || c == '_' || c == '.';
    if (c == ']' || c == ')') continue;
    if (!separates)
      n += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!n.empty() && n.back() != '_')
      n += '_';
  }
  while (!n.empty() && n.back() == '_') n.pop_back();
  return n;
}

bool is_angle(const NumberColumn& c) { return c.unit == degree; }

std::string units_of(const NumberColumn& c) {
  return is_angle(c) ? "deg or rad" : "mm, cm, m or in";
}

/// The column of this base whose unit has this dimension; otherwise any column of this base.
const NumberColumn* column_of(std::string_view base, const UnitSuffix* unit) {
  const NumberColumn* found = nullptr;
  for (const NumberColumn& c : number_columns())
    if (c.base == base && (!found || (unit && unit->angle == is_angle(c)))) found = &c;
  return found;
}

const UnitSuffix* suffix_named(std::string_view name) {
  const auto place = std::ranges::find(suffixes, name, &UnitSuffix::name);
  return place == suffixes.end() ? nullptr : &*place;
}

/// The name that is probably meant: "did you mean r_tip_mm?" or the list of all.
std::string expected_name(const std::string& name) {
  std::vector<std::string> all;
  for (const LabelColumn& l : labels) all.emplace_back(l.name);
  for (const NumberColumn& c : number_columns()) all.push_back(c.name());
  const std::size_t end = name.rfind('_');
  for (const std::string& base : {name, name.substr(0, end)})
    for (const auto& [other, column] : other_names)
      if (other == base) {
        const NumberColumn* c = column_of(column, nullptr);
        return c ? c->name() : std::string(column);
      }
  if (const auto near = nearest_name(name, all)) return *near;
  return fmt::format("one of {}, or note", fmt::join(all, ", "));
}

/// Whether the name begins with the base of a column: "r_tip", "r_tip_ft".
const NumberColumn* column_with_other_unit(std::string_view name) {
  for (const NumberColumn& c : number_columns())
    if (name == c.base || (name.starts_with(c.base) && name.substr(c.base.size()).front() == '_' &&
                           name.rfind('_') == c.base.size()))
      return &c;
  return nullptr;
}

void add_unknown(long line, const std::string& name, CsvMistakes& mistakes) {
  if (name.starts_with("exposure"))
    return mistakes.add(line, name, "a column of exposures",
                        "under_exposure_mm here, exposure in the bit file's [blades]");
  if (const NumberColumn* c = column_with_other_unit(name)) {
    const std::string found = name == c->base
                                  ? "a column without a unit"
                                  : fmt::format("the unit \"{}\"", name.substr(c->base.size() + 1));
    return mistakes.add(
        line, name, found,
        fmt::format("{} at the end of the name, as in {}", units_of(*c), c->name()));
  }
  mistakes.add(line, name, "an unknown column", expected_name(name));
}

/// Adds a column of numbers; returns false if the name is not one.
bool take_number(const std::string& name, std::size_t cell, CutterColumns& columns) {
  const std::size_t end = name.rfind('_');
  if (end == std::string::npos) return false;
  const UnitSuffix* unit = suffix_named(std::string_view(name).substr(end + 1));
  const NumberColumn* column = column_of(std::string_view(name).substr(0, end), unit);
  if (!unit || !column || unit->angle != is_angle(*column)) return false;
  columns.numbers.push_back({column, name, cell, unit->si});
  return true;
}

}  // namespace

const std::vector<NumberColumn>& number_columns() {
  static const std::vector<NumberColumn> columns{
      {"dia", "mm", &Cutter::diameter, mm, true, tiny, large, "a positive diameter", "",
       "diameter of the cutter"},
      {"r_tip", "mm", &Cutter::tip_radius, mm, true, 0, large, "a radius >= 0", "",
       "distance of the tip from the bit's axis, not a diameter"},
      {"phi", "deg", &Cutter::azimuth, degree, true, -360, 360, "an angle in -360..360", "",
       "azimuth of the tip about the axis, clockwise as seen from above"},
      {"h_tip", "mm", &Cutter::tip_height, mm, true, -large, large, "a height", "",
       "height of the tip above the nose, positive towards the shank"},
      {"profile_angle", "deg", &Cutter::profile_angle, degree, true, -90, 100,
       "an angle in -90..100", "",
       "of the profile's normal: 0 on the nose, negative in the cone, 90 on the gage"},
      {"back_rake", "deg", &Cutter::back_rake, degree, true, -5, 60, "an angle in -5..60", "",
       "back rake; positive: the face leans over the rock ahead of it"},
      {"side_rake", "deg", &Cutter::side_rake, degree, true, -45, 45, "an angle in -45..45", "",
       "side rake: turns the face about the line from its centre to its tip"},
      {"chamfer", "mm", &Cutter::chamfer, mm, false, 0, large, "a width >= 0", "cutters.chamfer",
       "width of the chamfer along the face; 0: sharp"},
      {"chamfer", "deg", &Cutter::chamfer_angle, degree, false, 10, 80, "an angle in 10..80",
       "cutters.chamfer_angle", "of the chamfer, from the cutter's axis"},
      {"length", "mm", &Cutter::length, mm, false, tiny, large, "a positive length",
       "cutters.length", "of the cutter along its axis"},
      {"table", "mm", &Cutter::table_thickness, mm, false, tiny, large, "a positive thickness",
       "cutters.table_thickness", "thickness of the diamond table"},
      {"land", "mm", &Cutter::land, mm, false, 0, large, "a width >= 0", "cutters.land",
       "width of a second chamfer inside the first; 0: none"},
      {"land", "deg", &Cutter::land_angle, degree, false, 10, 85, "an angle in 10..85",
       "cutters.land_angle", "of that second chamfer, from the cutter's axis"},
      {"wear", "mm", &Cutter::wear, mm, false, 0, large, "a height >= 0", "0",
       "height of the wear flat along the profile's normal"},
      {"under_exposure", "mm", &Cutter::under_exposure, mm, false, 0, large, "a depth >= 0", "0",
       "of a back-up cutter: distance of its tip inside the profile; r_tip and h_tip include it"},
  };
  return columns;
}

CutterColumns read_cutter_columns(const CsvRow& header, CsvMistakes& mistakes) {
  CutterColumns columns;
  std::vector<const void*> seen;  // labels and columns of numbers
  for (const std::string& text : header.cells) {
    const auto cell = static_cast<std::size_t>(&text - header.cells.data());
    const std::string name = normalized(text);
    const void* what = nullptr;
    if (name.empty() || std::ranges::count(note_columns, name) > 0) continue;
    if (const auto l = std::ranges::find(labels, name, &LabelColumn::name); l != labels.end()) {
      columns.labels.emplace(name, cell);
      what = &*l;
    } else if (take_number(name, cell, columns)) {
      what = columns.numbers.back().column;
    } else {
      add_unknown(header.line, name, mistakes);
      continue;
    }
    if (std::ranges::count(seen, what) > 0)
      mistakes.add(header.line, name, "the column twice", "it once");
    seen.push_back(what);
  }
  const auto need = [&](const void* what, const std::string& name) {
    if (std::ranges::count(seen, what) == 0)
      mistakes.add(header.line, name, "no such column", "it in the header");
  };
  for (const LabelColumn& l : labels)
    if (l.required) need(&l, std::string(l.name));
  for (const NumberColumn& c : number_columns())
    if (c.required) need(&c, c.name());
  std::ranges::stable_sort(columns.numbers, {}, &CutterColumns::Number::column);
  return columns;
}

KeyTable cutter_table_keys() {
  KeyTable table{
      "bit", "cutter-table", "the columns of a cutter table (CSV), not of TOML", Repeats::no, {}};
  for (const LabelColumn& l : labels)
    table.rows.push_back({.name = std::string(l.name),
                          .kind = std::string(l.kind),
                          .fallback = std::string(l.fallback),
                          .allowed = "",
                          .meaning = std::string(l.meaning)});
  for (const NumberColumn& c : number_columns()) {
    std::string allowed = c.highest == large
                              ? (c.lowest == 0.0    ? ">= 0"
                                 : c.lowest == tiny ? "> 0"
                                                    : "")
                              : fmt::format("{:g}..{:g} {}", c.lowest, c.highest, c.unit_name);
    table.rows.push_back({.name = c.name(),
                          .kind = is_angle(c) ? "angle" : "length",
                          .fallback = c.required ? "required" : std::string(c.fallback),
                          .allowed = std::move(allowed),
                          .meaning = std::string(c.meaning)});
  }
  return table;
}

}  // namespace tdbd::bit
