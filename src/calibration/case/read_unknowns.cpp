#include "calibration/case/read_unknowns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "simulation/case/force_keys.hpp"

namespace tdbd::calibration {
namespace {

using forces::LawField;

/// Records a mistake unless the start value, such as "18 deg", is inside the range: at a bound, a
/// coefficient could not change.
void check_start(Config& table, const Unknown& u) {
  const bool inside = u.start > u.range.lo && u.start < u.range.hi;
  if (!inside)
    table.problem(calibration_keys::start, fmt::format("{:.6g}", u.start),
                  fmt::format("a value between {:.6g} and {:.6g}", u.range.lo, u.range.hi));
}

Range read_range(Config& table, const LawField& field) {
  if (!table.has(calibration_keys::range)) return field.range;
  const auto given = table.list(calibration_keys::range, std::string(field.unit), std::nullopt);
  if (given.size() == 2 && given[0] < given[1] && given[0] >= field.range.lo &&
      given[1] <= field.range.hi)
    return Range::within(given[0], given[1]);
  table.problem(calibration_keys::range, fmt::format("[{:.6g}]", fmt::join(given, ", ")),
                fmt::format("[lowest, highest], rising, within {:.6g} and {:.6g}", field.range.lo,
                            field.range.hi));
  return field.range;
}

}  // namespace

Unknown read_unknown(Config table, const LawField& field) {
  Unknown u;
  u.key = u.coefficient = field.key;
  u.place = table.place("");
  u.range = read_range(table, field);
  u.start = table.quantity(calibration_keys::start, std::string(field.unit), std::nullopt);
  if (table.has(calibration_keys::prior_sd))
    u.prior_sd = table.quantity(calibration_keys::prior_sd, std::string(field.unit), std::nullopt,
                                Range::positive());
  check_start(table, u);
  return u;
}

void refuse_strangers(Config& table, const std::vector<forces::LawField>& fields,
                      std::string_view law) {
  std::vector<std::string> names;
  names.reserve(fields.size());
  for (const LawField& f : fields) names.emplace_back(f.key);
  for (const std::string& given : table.given()) {
    if (std::ranges::find(names, given) != names.end()) continue;
    const auto near = nearest_name(given, names);
    table.problem(
        given, "no coefficient of " + std::string(law),
        near ? fmt::format("{}?", *near) : fmt::format("one of {}", fmt::join(names, ", ")));
  }
}

std::vector<Unknown> read_unknowns(Config& c, forces::Law& law) {
  Config unknowns = c.table("unknowns"), fixed = c.table(calibration_keys::fixed);
  const std::vector<LawField> fields = forces::law_fields(law);
  refuse_strangers(unknowns, fields, forces::law_name(law));
  refuse_strangers(fixed, fields, forces::law_name(law));
  std::vector<Unknown> read;
  for (const LawField& f : fields) {
    if (unknowns.has(f.key)) {
      if (fixed.has(f.key))
        fixed.problem(f.key, "a value for what is fitted", "it here or in [unknowns], not in both");
      read.push_back(read_unknown(unknowns.table(f.key), f));
      *f.value = read.back().start;
    } else {
      *f.value = fixed.read(simulation::force_keys::key_of(f), f.fallback);
    }
  }
  return read;
}

}  // namespace tdbd::calibration
