#include "simulation/case/case_wear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bit/areas/read_areas.hpp"
#include "core/types.hpp"
#include "simulation/case/force_keys.hpp"
#include "simulation/case/run_keys.hpp"
#include "simulation/case/wear_keys.hpp"

namespace tdbd::simulation {
namespace {

bit::SlidingWear read_sliding(Config& c) {
  return {c.read(wear_keys::coefficient), c.read(wear_keys::hardness)};
}

/// Rates above 0 or 0, at rising temperatures.
bit::TableWear read_rates(Config& c) {
  bit::TableWear t{c.read(wear_keys::temperatures), c.read(wear_keys::rates)};
  if (!c.has(wear_keys::temperatures) || !c.has(wear_keys::rates)) return t;
  if (t.temperatures.empty() || t.rates.size() != t.temperatures.size())
    c.problem(wear_keys::rates,
              fmt::format("{} rates for {} temperatures", t.rates.size(), t.temperatures.size()),
              "one for each temperature, and at least one");
  for (const double rate : t.rates)
    if (!(rate >= 0.0)) {
      c.problem(wear_keys::rates, fmt::format("{}", rate), "rates, >= 0");
      break;
    }
  for (std::size_t i = 1; i < t.temperatures.size(); ++i)
    if (!(t.temperatures[i] > t.temperatures[i - 1])) {
      c.problem(wear_keys::temperatures,
                fmt::format("{} K after {} K", t.temperatures[i], t.temperatures[i - 1]),
                "rising temperatures");
      break;
    }
  return t;
}

bit::WearLaw read_wear_law(Config& c) {
  switch (c.read(wear_keys::law)) {
    case WearKind::sliding:
      return read_sliding(c);
    case WearKind::thermal:
      return bit::ThermalWear{read_sliding(c), c.read(wear_keys::threshold),
                              c.read(wear_keys::growth)};
    case WearKind::table:
      return read_rates(c);
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

/// Gage pads are of another material, and wear only where an area says so.
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
  if (!c.has(wear_keys::areas.name)) return;
  bit::Areas areas = bit::read_areas(c.table(wear_keys::areas), bit, where);
  std::vector<bit::WearLaw> laws;
  std::vector<std::optional<double>> values;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < areas.tables.size(); ++i) {
    Config& table = areas.tables[i].config;
    require_parts_that_wear(table, bit, bit::parts_of_rule(areas, static_cast<int>(i)));
    laws.push_back(read_wear_law(table));
    // Equal laws have the same value.
    values.emplace_back(static_cast<double>(std::ranges::find(laws, laws.back()) - laws.begin()));
    shown.push_back(std::visit(
        [](const auto& l) { return fmt::format("\"{}\" with its coefficients", l.name); },
        laws.back()));
  }
  const std::vector<int> decided =
      bit::decide_or_report(areas, bit, wear_keys::law.name, values, shown);
  for (std::size_t p = 0; p < decided.size(); ++p)
    if (decided[p] >= 0) plan.part_laws[p] = laws[at(decided[p])];
}

void require_wearing_bit(Config& c, const bit::Bit& bit, const ForcePlan& forces) {
  if (bit.parts.empty()) return;  // its own mistakes are noted
  const bool is_from_meshes = bit.cutter_source == bit::CutterSource::meshes;
  if (is_from_meshes || std::ranges::none_of(bit.parts, can_wear))
    c.problem(
        "",
        is_from_meshes ? "a bit whose cutters come from meshes" : "a bit without cutters and teeth",
        "a bit with a cutter table or with cones");
  if (forces.forces == Forces::off)
    c.problem("", "no table [forces]", "force laws: wear follows from the forces on the cutters");
}

/// Parts that start by wear need cutters that wear.
void require_wear_of_starts(Config& whole, const bit::Bit& bit) {
  for (const bit::Part& part : bit.parts)
    if (part.start && part.start->event == bit::StartEvent::wear)
      return whole.problem(
          wear_keys::table.name,
          fmt::format("no table, but {} gives {} removal.from_wear", part.start->place, part.name),
          "[wear], or another start");
}

}  // namespace

WearPlan read_wear(Config& whole, const bit::Bit& bit, const ForcePlan& forces) {
  WearPlan plan;
  if (!whole.has(wear_keys::table)) {
    require_wear_of_starts(whole, bit);
    return plan;
  }
  Config c = whole.table(wear_keys::table);
  const bit::WearLaw law = read_wear_law(c);
  for (const bit::Part& part : bit.parts)
    plan.part_laws.push_back(wears_by_default(part) ? law : bit::WearLaw{bit::NoWear{}});
  plan.acceleration = c.read(wear_keys::acceleration);
  plan.from = c.read(wear_keys::from);
  plan.every_steps = c.read(wear_keys::every_steps);
  plan.every = c.read(wear_keys::every);
  plan.largest_growth = c.read(wear_keys::largest_growth);
  plan.heating = {c.read(wear_keys::friction), c.read(wear_keys::rock_conductivity),
                  c.read(wear_keys::rock_diffusivity), c.read(wear_keys::cutter_resistance),
                  c.read(wear_keys::fluid_temperature)};
  const std::string where =
      fmt::format("{} of {}", bit.name, whole.table(bit_keys::table).read(bit_keys::file));
  read_wear_areas(c, bit, where, plan);
  require_wearing_bit(c, bit, forces);
  return plan;
}

}  // namespace tdbd::simulation
