
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bit/areas/area_rules.hpp"
#include "core/types.hpp"
#include "simulation/case/force_settings.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {
namespace {

/// Checks that rates are not negative and temperatures ascend.
void check_rates(Config& c, const bit::TableWear& t) {
  if (!c.has("temperatures") || !c.has("rates")) return;
  if (t.temperatures.empty() || t.rates.size() != t.temperatures.size())
    c.problem("rates",
              fmt::format("{} rates for {} temperatures", t.rates.size(), t.temperatures.size()),
              "one for each temperature, and at least one");
  for (const double rate : t.rates)
    if (!(rate >= 0.0)) {
      c.problem("rates", fmt::format("{}", rate), "rates, >= 0");
      break;
    }
  for (std::size_t i = 1; i < t.temperatures.size(); ++i)
    if (!(t.temperatures[i] > t.temperatures[i - 1])) {
      c.problem("temperatures",
                fmt::format("{} K after {} K", t.temperatures[i], t.temperatures[i - 1]),
                "rising temperatures");
      break;
    }
}

bit::WearLaw read_wear_law(Config& c) {
  WearLawSettings s;
  read_fields(c, s);
  switch (s.law) {
    case WearKind::sliding:
      return s.sliding;
    case WearKind::thermal:
      return bit::ThermalWear{s.sliding, s.threshold, s.growth};
    case WearKind::table:
      check_rates(c, s.rates);
      return s.rates;
    case WearKind::none:
      break;
  }
  return bit::NoWear{};
}

/// Parts of cutters, teeth and gage pads can wear.
bool can_wear(const bit::Part& part) {
  return part.cutter >= 0 || part.kind == bit::PartKind::tooth ||
         part.kind == bit::PartKind::gage_pad;
}

/// Gage pads are of another material, and wear only if an area defines it.
bool wears_by_default(const bit::Part& part) {
  return part.cutter >= 0 || part.kind == bit::PartKind::tooth;
}

void require_parts_that_wear(Config& c, const bit::Bit& bit, const std::vector<int>& parts) {
  for (const int p : parts)
    if (const bit::Part& part = bit.parts[at(p)]; !can_wear(part))
      return c.problem("", fmt::format("{}, which is none of these", part.name),
                       "criteria that select parts of cutters, teeth or gage pads: others do not "
                       "wear");
}

void read_wear_areas(Config& c, const bit::Bit& bit, const std::string& where, WearPlan& plan) {
  if (!c.has("areas")) return;
  bit::Areas areas = bit::read_areas(c.table("areas"), bit, where);
  std::vector<bit::WearLaw> laws;
  std::vector<std::optional<double>> values;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < areas.tables.size(); ++i) {
    Config& table = areas.tables[i].config;
    require_parts_that_wear(table, bit, bit::parts_of_rule(areas, static_cast<int>(i)));
    laws.push_back(read_wear_law(table));
    // Equal laws have equal values.
    values.emplace_back(static_cast<double>(std::ranges::find(laws, laws.back()) - laws.begin()));
    shown.push_back(std::visit(
        [](const auto& l) { return fmt::format("\"{}\" with its coefficients", l.name); },
        laws.back()));
  }
  const std::vector<int> decided = bit::decide_or_report(areas, bit, "law", values, shown);
  for (std::size_t p = 0; p < decided.size(); ++p)
    if (decided[p] >= 0) plan.part_laws[p] = laws[at(decided[p])];
}

void require_wearing_bit(Config& c, const bit::Bit& bit, const ForcePlan& forces) {
  if (bit.parts.empty()) return;  // its mistakes are already recorded
  const bool is_from_meshes = bit.cutter_source == bit::CutterSource::meshes;
  if (is_from_meshes || std::ranges::none_of(bit.parts, can_wear))
    c.problem(
        "",
        is_from_meshes ? "a bit whose cutters come from meshes" : "a bit without cutters and teeth",
        "a bit with a cutter table or with cones");
  if (forces.forces == Forces::off)
    c.problem("", "no table [forces]", "force laws: wear follows from the forces on the cutters");
}

/// Parts that start by wear require cutters that wear.
void require_wear_of_starts(Config& whole, const bit::Bit& bit) {
  for (const bit::Part& part : bit.parts)
    if (part.start && part.start->event == bit::StartEvent::wear)
      return whole.problem(
          WearPlan::table.name,
          fmt::format("no table, but {} gives {} removal.from_wear", part.start->place, part.name),
          "[wear], or another start");
}

}  // namespace

WearPlan read_wear(Config& whole, const bit::Bit& bit, const ForcePlan& forces) {
  WearPlan plan;
  if (!whole.has(WearPlan::table)) {
    require_wear_of_starts(whole, bit);
    return plan;
  }
  Config c = whole.table(WearPlan::table);
  const bit::WearLaw law = read_wear_law(c);
  for (const bit::Part& part : bit.parts)
    plan.part_laws.push_back(wears_by_default(part) ? law : bit::WearLaw{bit::NoWear{}});
  read_fields(c, plan);
  const std::string where = fmt::format("{} of {}", bit.name, read_table<BitSettings>(whole).file);
  read_wear_areas(c, bit, where, plan);
  require_wearing_bit(c, bit, forces);
  return plan;
}

}  // namespace tdbd::simulation
