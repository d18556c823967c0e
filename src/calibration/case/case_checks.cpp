#include "calibration/case/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/types.hpp"

namespace tdbd::calibration {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::string or_nearest(const std::string& name, const std::vector<std::string>& names) {
  const auto near = nearest_name(name, names);
  return near ? fmt::format("{}?", *near) : fmt::format("one of {}", fmt::join(names, ", "));
}

void check_list(Config& top, std::string_view key, const std::vector<std::string>& names,
                const CalibrationCase& c) {
  std::vector<std::string> known, recorded;
  for (const Tool& t : c.tools) known.push_back(t.name);
  for (const Record& r : c.records.rows)
    if (!holds(recorded, r.tool)) recorded.push_back(r.tool);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    if (!holds(known, name))
      top.problem(key, fmt::format("'{}', which is not in [bits] or [cutters]", name),
                  or_nearest(name, known));
    else if (!recorded.empty() && !holds(recorded, name))
      top.problem(key, fmt::format("'{}', of which there are no records", name),
                  or_nearest(name, recorded));
    if (std::find(names.begin(), names.begin() + static_cast<long>(i), name) !=
        names.begin() + static_cast<long>(i))
      top.problem(key, fmt::format("'{}' twice", name), "each name once");
  }
}

/// Returns the unknown of this name, or null.
const Unknown* free_one(const CalibrationCase& c, std::string_view key) {
  const auto at = std::ranges::find(c.unknowns, key, &Unknown::key);
  return at == c.unknowns.end() ? nullptr : &*at;
}

std::size_t count_readings(const std::vector<Record>& rows, std::size_t load) {
  return static_cast<std::size_t>(std::ranges::count_if(
      rows, [&](const Record& r) { return r.readings[load].value.has_value(); }));
}

void check_readings(const CalibrationCase& c, const std::vector<Record>& rows,
                    std::vector<std::string>& mistakes) {
  for (const Record& r : rows)
    if (!r.readings[axial].value && !r.readings[turning].value)
      mistakes.push_back(fmt::format("{}:{}: {}: found nothing, expected a load: the row is fitted",
                                     c.records.file, r.line,
                                     load_names(c.records.kind)[axial].name));
  const auto priors = static_cast<std::size_t>(
      std::ranges::count_if(c.unknowns, [](const Unknown& u) { return u.prior_sd.has_value(); }));
  const std::size_t readings = count_readings(rows, axial) + count_readings(rows, turning);
  if (readings + priors < c.unknowns.size())
    mistakes.push_back(fmt::format(
        "{}: found {} readings and {} priors for {} unknowns, expected as many at least: more "
        "records, a prior_sd, or coefficients moved to [fixed]",
        c.unknowns.back().place, readings, priors, c.unknowns.size()));
}

void check_pressure(const CalibrationCase& c, const std::vector<Record>& rows,
                    std::vector<std::string>& mistakes) {
  const Unknown* share = free_one(c, "pressure_share");
  if (share == nullptr) return;
  std::set<double> pressures;
  for (const Record& r : rows) pressures.insert(r.pressure);
  if (pressures.size() > 1 && c.pressures == Pressures::combined) return;
  mistakes.push_back(fmt::format(
      "{}: found {}, expected records at two pressures at least, fitted together: a test at "
      "another pressure, or the share in [fixed]",
      share->place,
      c.pressures == Pressures::separate ? "a fit at each pressure alone" : "one pressure"));
}

void check_torque(const CalibrationCase& c, const std::vector<Record>& rows,
                  std::vector<std::string>& mistakes) {
  const Unknown *A1 = free_one(c, "A1"), *A3 = free_one(c, "A3");
  if (A1 == nullptr || A3 == nullptr || A1->prior_sd || A3->prior_sd) return;
  if (count_readings(rows, turning) > 0) return;
  const auto names = load_names(c.records.kind);
  mistakes.push_back(
      fmt::format("{}: found A1 and A3 free and no {}, expected a {} reading, a prior_sd for one "
                  "of the two, or one of them in [fixed]: {} alone sees their product",
                  A3->place, names[turning].name, names[turning].name, names[axial].name));
}

/// The geometry of a groove (calibration (2)) ends where the face is wholly in the rock.
void check_grooves(const CalibrationCase& c, std::vector<std::string>& mistakes) {
  constexpr double mm = 1e-3, rounding = 1e-9;
  if (c.records.kind != ToolKind::cutter) return;
  for (const Record& r : c.records.rows) {
    const SingleCutter& cutter = tool_named(c, r.tool).cutter;
    const double height = cutter.diameter * std::cos(cutter.back_rake);
    if (r.depth <= height * (1.0 + rounding)) continue;
    mistakes.push_back(fmt::format(
        "{}:{}: depth: found {:.4g} mm, expected at most {:.4g} mm, the height of the face of '{}' "
        "(diameter {:.4g} mm, back rake {:.3g} deg)",
        c.records.file, r.line, r.depth / mm, height / mm, r.tool, cutter.diameter / mm,
        cutter.back_rake / degree));
  }
}

/// A bit does not advance by more than this in a revolution: its cutters are not as high.
void check_advances(const CalibrationCase& c, std::vector<std::string>& mistakes) {
  constexpr double mm = 1e-3, largest_advance = 0.1;  // m
  if (c.records.kind != ToolKind::bit) return;
  for (const Record& r : c.records.rows)
    if (r.depth > largest_advance)
      mistakes.push_back(fmt::format(
          "{}:{}: rate_of_penetration: found {:.4g} m/s at {:.4g} rad/s, {:.4g} mm per revolution, "
          "expected at most {:.4g} mm per revolution: is a unit of the header wrong?",
          c.records.file, r.line, r.rate, r.speed, r.depth / mm, largest_advance / mm));
}

}  // namespace

void check_names(Config& top, const CalibrationCase& c) {
  check_list(top, "fit_bits", c.fit, c);
  check_list(top, "predict_bits", c.predict, c);
  if (c.fit.empty() && !c.unknowns.empty())
    top.problem("fit_bits", "none", "at least one bit or cutter: there are unknowns");
  if (c.fit.empty() && c.predict.empty())
    top.problem("predict_bits", "none", "bits or cutters to fit or to predict");
  for (const std::string& name : c.predict)
    if (holds(c.fit, name))
      top.problem("predict_bits", fmt::format("'{}', which is fitted", name),
                  "bits that the fit does not see");
}

void choose_records(Config& top, const std::vector<std::string>& left_out, CalibrationCase& c) {
  std::vector<std::string> tests, rocks;
  for (const Record& r : c.records.rows)
    if (!holds(tests, r.test)) tests.push_back(r.test);
  for (const std::string& test : left_out)
    if (!holds(tests, test))
      top.problem("leave_out", fmt::format("'{}', a test without records", test),
                  or_nearest(test, tests));
  std::vector<Record> kept;
  for (const Record& r : c.records.rows)
    if ((holds(c.fit, r.tool) || holds(c.predict, r.tool)) && !holds(left_out, r.test))
      kept.push_back(r);
  c.records.rows = kept;
  std::erase_if(c.tools,
                [&](const Tool& t) { return !holds(c.fit, t.name) && !holds(c.predict, t.name); });
  for (const Tool& t : c.tools)
    if (t.kind != c.records.kind && !c.records.rows.empty())
      top.problem("records", fmt::format("tests of another kind than '{}'", t.name),
                  "a column bit for bits, a column cutter for cutters");
  for (const Record& r : kept) {
    if (c.rock.materials.contains(r.rock)) continue;
    try {
      c.rock.materials[r.rock] = forces::rock_named(r.rock);
    } catch (const InputError& e) {
      c.rock.materials[r.rock] = {};
      top.other_file(fmt::format("{}:{}: rock: {}", c.records.file, r.line, e.what()));
    }
  }
}

void check_calibration(const CalibrationCase& c) {
  const std::vector<Record> rows = records_of(c, c.fit);
  std::vector<std::string> mistakes;
  check_readings(c, rows, mistakes);
  check_pressure(c, rows, mistakes);
  check_torque(c, rows, mistakes);
  check_grooves(c, mistakes);
  check_advances(c, mistakes);
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

}  // namespace tdbd::calibration
