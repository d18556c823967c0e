#include "simulation/case/case_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/config/config.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

/// How a kind is told, and named.
struct Sign {
  CaseKind kind;
  const char* table;  ///< that no other kind has
  const char* name;
  const char* command;
};

constexpr Sign signs[] = {
    {CaseKind::rotation, "body", "a body to rotate", "rotate"},
    {CaseKind::calibration, "calibration", "a calibration", "calibrate"},
    {CaseKind::sweep, "sweep", "a sweep's design", "sweep"},
    {CaseKind::laboratory, "laboratory", "a synthetic laboratory", "laboratory"},
    {CaseKind::string, "string.sections", "a drill string", "string"},
    {CaseKind::string, "string.model", "a drill string", "string"},
    {CaseKind::drilling, "motion", "a case to drill", "run"},
    {CaseKind::bit, "cutters", "a bit", "bit"},
    {CaseKind::bit, "design", "a bit", "bit"},
    {CaseKind::bit, "journal", "a bit", "bit"},
    {CaseKind::bit, "solids", "a bit", "bit"},
};

const Sign& sign_of(CaseKind kind) { return *std::ranges::find(signs, kind, &Sign::kind); }

}  // namespace

CaseKind kind_of(const std::string& file, const std::vector<std::string>& overrides) {
  const Config c = Config::read_file(file, overrides);
  // A string with a bit of its own shape drills.
  const auto found = std::ranges::find_if(signs, [&](const Sign& s) {
    return c.has(s.table) && (s.kind != CaseKind::string || !c.has("bit"));
  });
  return found == std::end(signs) ? CaseKind::unknown : found->kind;
}

void require_kind(const std::string& file, const std::vector<std::string>& overrides,
                  const std::vector<CaseKind>& expected) {
  const CaseKind found = kind_of(file, overrides);
  if (found == CaseKind::unknown || std::ranges::count(expected, found) > 0) return;
  std::string names;
  for (const CaseKind kind : expected)
    names += (names.empty() ? "" : " or ") + std::string(sign_of(kind).name);
  const Sign& sign = sign_of(found);
  throw InputError(fmt::format("{}: found {}, with a table [{}], expected {}; try: tdbd {} {}",
                               file, sign.name, sign.table, names, sign.command, file));
}

}  // namespace tdbd::simulation
