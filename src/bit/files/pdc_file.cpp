#include "bit/files/pdc_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string_view>

#include "bit/body/blade_body.hpp"
#include "bit/cutter/table_doubts.hpp"
#include "bit/files/design_settings.hpp"
#include "bit/pdc/pdc_generator.hpp"
#include "core/config/csv.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// The angle at which the shoulder's arc begins: given, or computed from the arc's radius.
double shoulder_angle_of(Config& c, const ProfileSettings& s) {
  const ProfileDesign& p = s.profile;
  if (!c.has("shoulder_radius")) return p.shoulder_angle;
  if (c.has("shoulder_angle"))
    c.problem("shoulder_angle", "shoulder_radius as well", "one of the two");
  const double angle = shoulder_angle_for(p, s.shoulder_radius);
  if (angle >= 0.0) return angle;
  const double left = p.gage_radius - p.nose_place;
  c.problem("shoulder_radius",
            fmt::format("{:.6g} mm, no arc between nose and gage", 1e3 * s.shoulder_radius),
            fmt::format("at {} {:.6g} mm, what nose_place leaves to the gage",
                        p.nose_radius < left ? "least" : "most", 1e3 * left));
  return 0.0;
}

ProfileDesign read_profile(Config& design, double gage_radius) {
  ProfileSettings s;
  s.profile.gage_radius = gage_radius;
  s = read_table(design, s);
  Config c = design.table(ProfileSettings::table);
  s.profile.shoulder_angle = shoulder_angle_of(c, s);
  return s.profile;
}

template <class Settings>
RegionLaw read_law(Config& design) {
  const auto s = read_table<Settings>(design);
  return {s.first, s.nose, s.shoulder, s.gage};
}

std::vector<BladeDesign> read_blade_designs(Config& design) {
  std::vector<BladeDesign> blades;
  for (Config& table : design.tables(DesignBladeSettings::table)) {
    DesignBladeSettings s;
    read_fields(table, s);
    blades.push_back(s.blade);
  }
  return blades;
}

/// An angle (rad), or that of at most twelve digits in degrees from which it differs by rounding
/// only: -15 degrees after -17 + 2, not -14.999999999999998.
double without_rounding(double x) {
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double value = x / degree;
  const auto near = csv_number<double>(fmt::format("{:.12g}", value));
  return near && std::abs(*near - value) <= rounding * std::abs(value) ? *near * degree : x;
}

void increase(double& angle, double by) {
  if (by != 0.0) angle = without_rounding(angle + by);
}

void add(const Adjustment& a, Cutter& c) {
  increase(c.azimuth, a.azimuth);
  increase(c.back_rake, a.back_rake);
  increase(c.side_rake, a.side_rake);
  c.tip_radius += a.along * std::cos(c.profile_angle);
  c.tip_height += a.along * std::sin(c.profile_angle);
}

/// Numbers from `first` to `last`.
struct NumberRange {
  int first = 0, last = -1;
};

/// Reads "7", "22-39" or "1,4,22-39". Returns nothing for other texts.
std::vector<NumberRange> number_ranges(std::string_view text) {
  std::vector<NumberRange> ranges;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    NumberRange r;
    auto [rest, error] = std::from_chars(at, end, r.first);
    if (error != std::errc()) return {};
    r.last = r.first;
    if (rest != end && *rest == '-') {
      const auto second = std::from_chars(rest + 1, end, r.last);
      if (second.ec != std::errc() || r.last < r.first) return {};
      rest = second.ptr;
    }
    ranges.push_back(r);
    if (rest == end) return ranges;
    if (*rest != ',') return {};
    at = rest + 1;
  }
}

/// A table of [adjust] and the cutters that it changes.
struct AppliedChange {
  Config config;
  Adjustment change;
  std::vector<std::uint8_t> selects;  ///< of each cutter
};

/// Applies the tables of `c`, each to the cutters that its name selects: [adjust.blade.2],
/// [adjust.zone.nose]. `what` and `expected` describe, for messages, what a table must select.
template <class Selects>
void adjust_some(Config c, const char* what, const std::string& expected, const Selects& selects,
                 std::vector<Cutter>& cutters, std::vector<AppliedChange>& applied) {
  for (const std::string& name : c.given()) {
    AppliedChange a{c.table(name), {}, {}};
    read_fields(a.config, a.change);
    for (Cutter& cutter : cutters) {
      a.selects.push_back(selects(name, cutter) ? 1 : 0);
      if (a.selects.back() != 0) add(a.change, cutter);
    }
    const std::vector<std::string> given = a.config.given();
    if (std::ranges::count(a.selects, 1) == 0 && !cutters.empty())
      a.config.problem(given.empty() ? "" : given.front(),
                       fmt::format("no {} {} in the bit", what, name), expected);
    applied.push_back(std::move(a));
  }
}

bool selects_number(const std::string& name, int number) {
  return std::ranges::any_of(number_ranges(name), [&](const NumberRange& r) {
    return r.first <= number && number <= r.last;
  });
}

/// "cone, nose, shoulder or gage", as in the table.
std::string zones_of(const std::vector<Cutter>& cutters) {
  std::vector<std::string> zones;
  for (const Cutter& c : cutters)
    if (std::ranges::count(zones, c.zone) == 0) zones.push_back(c.zone);
  return listed(zones);
}

/// The different numbers as ranges: "1-5, 7".
std::string number_text(const std::vector<Cutter>& cutters, int Cutter::*member) {
  std::set<int> numbers;
  for (const Cutter& c : cutters) numbers.insert(c.*member);
  std::string text;
  for (auto at = numbers.begin(); at != numbers.end();) {
    const int first = *at;
    int last = first;
    while (++at != numbers.end() && *at == last + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", first);
    if (last > first) text += fmt::format("-{}", last);
  }
  return text;
}

/// A value of a cutter that [adjust] changes, and its limits in a cutter table.
struct AdjustedValue {
  const char* key;
  double Adjustment::*change;
  double Cutter::*value;
  double unit;
  const char* unit_name;
  double lowest, highest;  ///< in that unit
  const char* expected;
};

constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr AdjustedValue adjusted_values[] = {
    {"back_rake", &Adjustment::back_rake, &Cutter::back_rake, degree, "deg", -5.0, 60.0,
     "an angle in -5..60 deg"},
    {"side_rake", &Adjustment::side_rake, &Cutter::side_rake, degree, "deg", -45.0, 45.0,
     "an angle in -45..45 deg"},
    {"along", &Adjustment::along, &Cutter::tip_radius, 1e-3, "mm from the axis", 0.0, no_limit,
     "a radius >= 0"}};

/// Records a value that a cutter table would not allow either, at the largest change of it.
void check_adjusted(std::vector<AppliedChange>& applied, const Cutter& cutter, std::size_t index) {
  for (const AdjustedValue& v : adjusted_values) {
    const double found = cutter.*v.value / v.unit;
    if (found >= v.lowest && found <= v.highest) continue;
    const auto size = [&](const AppliedChange& a) {
      return a.selects[index] != 0 ? std::abs(a.change.*v.change) : -1.0;
    };
    AppliedChange& a = *std::ranges::max_element(applied, {}, size);
    const bool bare = a.config.has(v.key) && !a.config.is_text(v.key);
    const bool is_angle = v.unit == degree;
    a.config.problem(
        v.key,
        fmt::format("{:.4g} {} at cutter {} after this change", found, v.unit_name, cutter.id),
        v.expected + (bare ? fmt::format(" (a number without a unit is in {}; write it as '5 {}')",
                                         is_angle ? "rad" : "m", is_angle ? "deg" : "mm")
                           : std::string()));
  }
}

/// Records problems that wrong rows of the table may have caused. The doubts about the table become
/// mistakes and come first.
template <class Problem>
void report_after_doubts(Config& c, const std::vector<Problem>& problems,
                         std::vector<BitDoubt>& doubts) {
  if (problems.empty()) return;
  if (doubts.empty()) {
    for (const Problem& p : problems) c.problem(p.key, p.found, p.expected);
    return;
  }
  for (const BitDoubt& d : doubts) c.other_file(d.place + ": " + d.text);
  for (const Problem& p : problems)
    c.other_file(fmt::format("{}: found {}, expected {}", c.place(p.key), p.found, p.expected));
  doubts.clear();
}

}  // namespace

std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape) {
  DesignSettings s;
  read_fields(c, s);
  PdcDesign d;
  d.shape = shape;
  d.profile = read_profile(c, gage_radius);
  d.blades = read_blade_designs(c);
  d.first_radius = s.first_radius;
  d.spiral = s.spiral;
  d.clearance = s.clearance;
  const auto diameter = read_table<DiameterByPlace>(c);
  d.diameter = {diameter.first, diameter.nose, diameter.shoulder, diameter.gage};
  d.overlap = read_law<OverlapByPlace>(c);
  d.back_rake = read_law<BackRakeByPlace>(c);
  d.side_rake = read_law<SideRakeByPlace>(c);
  d.wear = read_law<WearByPlace>(c);
  d.backups = read_table<BackupSettings>(c).row;
  d.gage = read_table<GageRowSettings>(c).row;
  if (c.problem_count() > 0) return {};
  const Layout layout = make_layout(d);
  for (const DesignProblem& p : layout.problems) c.problem(p.key, p.found, p.expected);
  return layout.problems.empty() ? layout.cutters : std::vector<Cutter>{};
}

std::vector<BitDoubt> check_table(Config& c, const std::string& table,
                                  const std::vector<Cutter>& cutters) {
  TableCheck s;
  read_fields(c, s);
  std::vector<BitDoubt> doubts;
  if (!s.table_check) return doubts;
  bool impossible = false;
  for (const TableDoubt& d : table_doubts(cutters)) {
    impossible = impossible || d.severity == Severity::impossible;
    doubts.push_back({fmt::format("{}:{}: {}", table, d.line, d.column), d.column,
                      fmt::format("found {}, expected {}", d.found, d.expected)});
  }
  if (!impossible) return doubts;
  for (const BitDoubt& d : doubts) c.other_file(d.place + ": " + d.text);
  return {};
}

void check_gage(Config& c, const std::string& table, const std::vector<Cutter>& cutters,
                double gage_radius, std::vector<BitDoubt>& doubts) {
  constexpr std::size_t fewest = 8;
  constexpr double too_small = 0.8, small = 0.98, too_large = 1.05;
  constexpr std::ptrdiff_t several = 3;
  if (cutters.size() < fewest || !std::isfinite(gage_radius) || c.problem_count() > 0) return;
  const Cutter& widest = std::ranges::max(cutters, {}, &Cutter::tip_radius);
  const double share = widest.tip_radius / gage_radius;
  const auto outside = std::ranges::count_if(
      cutters, [&](const Cutter& k) { return k.tip_radius > too_large * gage_radius; });
  const std::string found = mm_text(2.0 * gage_radius);
  const auto fits = [&](double factor) { return std::abs(factor * share - 1.0) < 1.0 - small; };
  const char* question = fits(25.4)         ? "; is the table in inches (r_tip_in)?"
                         : fits(1.0 / 25.4) ? "; is the table in mm (r_tip_mm)?"
                         : fits(10.0)       ? "; is the table in cm (r_tip_cm)?"
                         : fits(0.5)        ? "; are the radii diameters?"
                                            : "";
  const std::string expected =
      fmt::format("about {}: the outermost tip of {}, cutter {} in line {}, is at a radius of {}{}",
                  mm_text(2.0 * widest.tip_radius), table, widest.id, widest.line,
                  mm_text(widest.tip_radius), question);
  if (share < too_small || outside >= several)
    report_after_doubts(c, std::vector{PadProblem{"gage_diameter", found, expected}}, doubts);
  else if (share < small)
    doubts.push_back({c.place("gage_diameter"), "gage_diameter",
                      fmt::format("found {}, expected {}", found, expected)});
}

std::optional<BladeOptions> read_blades(Config& file) {
  if (!file.has(BladeSettings::table)) return {};
  return read_table<BladeSettings>(file).blades;
}

void check_pads(Config& file, const std::vector<Cutter>& cutters, const GagePads& pads,
                std::vector<BitDoubt>& doubts) {
  if (cutters.empty() || file.problem_count() > 0) return;
  Config c = file.table(PadSettings::table);
  const double gage = std::ranges::max(cutters, {}, &Cutter::tip_radius).tip_radius;
  report_after_doubts(c, pad_problems(pads, gage), doubts);
}

void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades,
                  std::vector<BitDoubt>& doubts) {
  if (cutters.empty() || file.problem_count() > 0) return;
  Config c = file.table(BladeSettings::table);
  const double gage = std::ranges::max(cutters, {}, &Cutter::tip_radius).tip_radius;
  report_after_doubts(c, blade_problems(cutters, blades, gage), doubts);
}

void adjust_cutters(Config adjust, std::vector<Cutter>& cutters) {
  if (adjust.given().empty()) return;
  std::vector<AppliedChange> applied{{adjust, {}, std::vector<std::uint8_t>(cutters.size(), 1)}};
  read_fields(adjust, applied.front().change);
  for (Cutter& c : cutters) add(applied.front().change, c);
  adjust_some(
      adjust.table("zone"), "zone", "a zone of the cutters: " + zones_of(cutters),
      [](const std::string& name, const Cutter& c) { return c.zone == name; }, cutters, applied);
  adjust_some(
      adjust.table("blade"), "blade",
      fmt::format("a blade or a range of these: {}", number_text(cutters, &Cutter::blade)),
      [](const std::string& name, const Cutter& c) { return selects_number(name, c.blade); },
      cutters, applied);
  adjust_some(
      adjust.table("cutter"), "cutter",
      fmt::format("a cutter or a range of these: {}", number_text(cutters, &Cutter::id)),
      [](const std::string& name, const Cutter& c) { return selects_number(name, c.id); }, cutters,
      applied);
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    check_adjusted(applied, cutters[i], i);
    cutters[i].X_BC = cutter_pose(cutters[i]);
  }
}

}  // namespace tdbd::bit
