#include "bit/areas/bit_areas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "bit/areas/area_rules.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cone/cone_parts.hpp"
#include "core/config/config.hpp"
#include "core/text.hpp"

namespace tdbd::bit {
namespace {

/// Per area, the value of the property, if given, and its text.
struct Values {
  std::vector<std::optional<double>> of_area;
  std::vector<std::string> shown;

  explicit Values(std::size_t areas) : of_area(areas), shown(areas) {}
};

struct StartSetting {
  StartEvent event = StartEvent::time;
  double from = 0.0;
  std::string worn_names;

  bool operator==(const StartSetting&) const = default;
};

std::string name_of(Material material) {
  for (const auto& named : AreaProperties::materials)
    if (!named.name.empty() && named.value == material) return std::string(named.name);
  return "";
}

/// Reads the properties that each area defines.
std::vector<AreaProperties> read_properties(Areas& areas) {
  std::vector<AreaProperties> given(areas.tables.size());
  for (std::size_t i = 0; i < given.size(); ++i) read_fields(areas.tables[i].config, given[i]);
  return given;
}

Values densities_of(Areas& areas, const std::vector<AreaProperties>& given) {
  Values v(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    const AreaProperties& g = given[i];
    if (g.material && g.density)
      areas.tables[i].config.problem("density", "material as well", "one of the two");
    if (g.material) v.of_area[i] = density_of(*g.material);
    if (g.density) v.of_area[i] = *g.density;
    if (!v.of_area[i]) continue;
    v.shown[i] = fmt::format("{:g} kg/m3", *v.of_area[i]);
    if (g.material && !g.density) v.shown[i] = name_of(*g.material) + ", " + v.shown[i];
  }
  return v;
}

Values cutting_of(const std::vector<AreaProperties>& given) {
  Values v(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i].cutting) continue;
    v.of_area[i] = static_cast<double>(*given[i].cutting);
    v.shown[i] = '"' + cutting_name(*given[i].cutting) + '"';
  }
  return v;
}

Values shares_of(const std::vector<AreaProperties>& given) {
  Values v(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    v.of_area[i] = given[i].share;
    if (given[i].share) v.shown[i] = fmt::format("a share of {:g}", *given[i].share);
  }
  return v;
}

/// Records a mistake if the pattern matches no cutter of the bit.
void check_worn_names(Config& c, const Bit& bit, const std::string& pattern) {
  if (!bit.parts.empty() && std::ranges::none_of(bit.parts, [&](const Part& p) {
        return p.cutter >= 0 && fits(pattern, p.name);
      }))
    c.problem("removal.worn_names",
              fmt::format("\"{}\", which no part of a cutter matches", pattern),
              "a pattern of names of parts of cutters, as bit.json lists them");
}

StartSetting start_of(Config& c, const Bit& bit, const AreaProperties& given) {
  if (given.from_depth) return {StartEvent::depth, *given.from_depth, {}};
  if (given.from_time) return {StartEvent::time, *given.from_time, {}};
  if (given.worn_names) check_worn_names(c, bit, *given.worn_names);
  if (!bit.parts.empty() && bit.cutters.empty())
    c.problem("removal.from_wear", "a bit without cutters", "cutters, which wear");
  return {StartEvent::wear, *given.from_wear, given.worn_names.value_or("*")};
}

std::string shown_start(const StartSetting& start) {
  if (start.event == StartEvent::wear)
    return fmt::format("a start at a wear of {:g} m of \"{}\"", start.from, start.worn_names);
  return fmt::format("a start at {:g} {}", start.from,
                     start.event == StartEvent::depth ? "m" : "s");
}

/// Records a mistake if an area has two starts.
void require_one_start(Config& c) {
  std::string_view first;
  for (const std::string_view key :
       {"removal.from_depth", "removal.from_time", "removal.from_wear"}) {
    if (!c.has(key)) continue;
    if (!first.empty()) c.problem(key, fmt::format("{} as well", first), "one of the two");
    first = key;
  }
  if (c.has("removal.worn_names") && !c.has("removal.from_wear"))
    c.problem("removal.worn_names", "no removal.from_wear", "removal.from_wear beside it");
}

/// Equal starts have equal values.
Values starts_of(Areas& areas, const Bit& bit, const std::vector<AreaProperties>& given,
                 std::vector<StartSetting>& starts) {
  Values v(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    Config& c = areas.tables[i].config;
    require_one_start(c);
    starts.emplace_back();
    if (!given[i].from_depth && !given[i].from_time && !given[i].from_wear) continue;
    starts[i] = start_of(c, bit, given[i]);
    v.of_area[i] = static_cast<double>(std::ranges::find(starts, starts[i]) - starts.begin());
    v.shown[i] = shown_start(starts[i]);
  }
  return v;
}

void require_known_removal(Areas& areas) {
  constexpr std::array known{"cutting",   "share",     "from_depth",
                             "from_time", "from_wear", "worn_names"};
  for (AreaTable& area : areas.tables)
    for (const std::string& key : area.config.table("removal").given())
      if (std::ranges::find(known, key) == known.end())
        area.config.problem("removal." + key, "an unknown key",
                            "cutting, share, from_depth, from_time, from_wear or worn_names");
}

/// Records a mistake for an area without properties; their keys were probably forgotten.
void require_properties(Areas& areas, const std::vector<const Values*>& properties) {
  for (std::size_t i = 0; i < areas.tables.size(); ++i)
    if (std::ranges::none_of(properties,
                             [&](const Values* v) { return v->of_area[i].has_value(); }))
      areas.tables[i].config.problem("", "no property",
                                     "density, material, removal.cutting, removal.share, "
                                     "removal.from_depth, removal.from_time or "
                                     "removal.from_wear");
}

bool counts_elsewhere(const Part& part, const std::vector<std::string>& without_density) {
  return part.density == 0.0 &&
         std::ranges::find(without_density, part.name) == without_density.end();
}

void apply_densities(Areas& areas, const Values& v, const std::vector<AreaProperties>& given,
                     Bit& bit, std::vector<std::string>& without_density) {
  const std::vector<int> decided = decide_or_report(areas, bit, "density", v.of_area, v.shown);
  for (std::size_t i = 0; i < areas.tables.size(); ++i) {
    const std::vector<int> parts = parts_of_rule(areas, static_cast<int>(i));
    if (!v.of_area[i] || parts.empty()) continue;
    if (std::ranges::all_of(parts, [&](int p) {
          return counts_elsewhere(bit.parts[static_cast<std::size_t>(p)], without_density);
        }))
      areas.tables[i].config.problem(
          "density",
          fmt::format("{} for {}, whose volume counts elsewhere", v.shown[i],
                      bit.parts[static_cast<std::size_t>(parts.front())].name),
          "criteria that select a part with a density");
  }
  for (std::size_t p = 0; p < decided.size(); ++p) {
    Part& part = bit.parts[p];
    if (decided[p] < 0 || counts_elsewhere(part, without_density)) continue;
    const auto area = static_cast<std::size_t>(decided[p]);
    part.density = *v.of_area[area];
    part.density_area = areas.rules[area].name;
    part.material = given[area].material ? name_of(*given[area].material) : "";
    std::erase(without_density, part.name);
  }
}

void apply_cutting(Areas& areas, const Values& v, Bit& bit) {
  const std::vector<int> decided =
      decide_or_report(areas, bit, "removal.cutting", v.of_area, v.shown);
  for (std::size_t p = 0; p < decided.size(); ++p) {
    if (decided[p] < 0) continue;
    Part& part = bit.parts[p];
    const auto area = static_cast<std::size_t>(decided[p]);
    part.cutting = static_cast<Cutting>(static_cast<int>(*v.of_area[area]));
    part.cutting_area = areas.rules[area].name;
    if (part.cutting == Cutting::rubs &&
        (part.kind == PartKind::face || part.kind == PartKind::chamfer))
      areas.tables[area].config.problem(
          "removal.cutting", fmt::format("\"rubs\" for {}", part.name),
          fmt::format("\"yes\" or \"no\" for a {}, whose force comes from what the face cuts",
                      kind_words(part.kind)));
  }
}

/// Whether a part passes over rock: rock beside a body or a cone's shell never leaves it, so its
/// passes do not end.
bool passes_over_rock(const Part& part) {
  return part.kind != PartKind::bit_body && part.kind != PartKind::cone;
}

void apply_shares(Areas& areas, const Values& v, Bit& bit) {
  const std::vector<int> decided =
      decide_or_report(areas, bit, "removal.share", v.of_area, v.shown);
  for (std::size_t p = 0; p < decided.size(); ++p) {
    if (decided[p] < 0) continue;
    Part& part = bit.parts[p];
    const auto area = static_cast<std::size_t>(decided[p]);
    Config& c = areas.tables[area].config;
    part.share = *v.of_area[area];
    part.share_area = areas.rules[area].name;
    if (part.cutting != Cutting::cuts)
      c.problem("removal.share",
                fmt::format("{} for {}, which removes no rock", v.shown[area], part.name),
                "removal.cutting = \"yes\" for it, or criteria without it");
    else if (part.share < 1.0 && !passes_over_rock(part))
      c.problem("removal.share",
                fmt::format("{} for {}, a {}, which rock beside it never leaves", v.shown[area],
                            part.name, kind_words(part.kind)),
                "criteria that select parts of cutters, gage pads or teeth");
  }
}

void apply_starts(Areas& areas, const Values& v, const std::vector<StartSetting>& starts,
                  Bit& bit) {
  const std::vector<int> decided =
      decide_or_report(areas, bit, "removal.from_depth", v.of_area, v.shown);
  for (std::size_t p = 0; p < decided.size(); ++p) {
    if (decided[p] < 0) continue;
    Part& part = bit.parts[p];
    const auto area = static_cast<std::size_t>(decided[p]);
    if (part.cutting == Cutting::never)
      areas.tables[area].config.problem(
          "", fmt::format("{} for {}, which never cuts or rubs", v.shown[area], part.name),
          "removal.cutting = \"yes\" or \"rubs\" for it, or criteria without it");
    part.start = {starts[area].event, starts[area].from, part.cutting, starts[area].worn_names,
                  areas.rules[area].place};
    part.cutting = Cutting::never;
    part.start_area = areas.rules[area].name;
  }
}

bool has_layout(const Bit& bit, const Part& part) {
  return part.cone >= 0 && !bit.cones[static_cast<std::size_t>(part.cone)].layout.shell.empty();
}

/// The parts of the cones according to their layouts, by name.
std::map<std::string, Part> parts_of_layouts(const Bit& bit) {
  std::map<std::string, Part> parts;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    if (!bit.cones[k].layout.shell.empty())
      for (Part& part : cone_parts(bit.cones[k], static_cast<int>(k)))
        parts.emplace(part.name, std::move(part));
  return parts;
}

std::string start_lines(const LateStart& start) {
  switch (start.event) {
    case StartEvent::depth:
      return fmt::format("removal.from_depth = {}  # m\n", start.from);
    case StartEvent::time:
      return fmt::format("removal.from_time = {}  # s\n", start.from);
    case StartEvent::wear:
      break;
  }
  return fmt::format("removal.from_wear = {}  # m\nremoval.worn_names = {}\n", start.from,
                     toml_string(start.worn_names));
}

}  // namespace

double density_of(Material m) {
  switch (m) {
    case Material::steel:
      return 7850.0;
    case Material::tungsten_carbide:
      return 14.9e3;
    case Material::pdc_diamond:
      break;
  }
  return 3500.0;
}

void apply_areas(Config& file, Bit& bit, std::vector<std::string>& without_density) {
  if (!file.has("areas")) return;
  Areas areas = read_areas(file.table("areas"), bit, fmt::format("the bit {}", bit.name));
  const double reach_of_design = largest_turned_radius(bit);
  std::vector<StartSetting> given_starts;
  const std::vector<AreaProperties> given = read_properties(areas);
  const Values density = densities_of(areas, given), cutting = cutting_of(given),
               share = shares_of(given), start = starts_of(areas, bit, given, given_starts);
  require_known_removal(areas);
  require_properties(areas, {&density, &cutting, &share, &start});
  apply_densities(areas, density, given, bit, without_density);
  apply_cutting(areas, cutting, bit);
  apply_shares(areas, share, bit);
  apply_starts(areas, start, given_starts, bit);
  if (const double reach = largest_turned_radius(bit); reach > 0.0 && reach < reach_of_design)
    bit.gage_radius = reach;
  if (file.problem_count() == 0 && std::ranges::none_of(bit.parts, [](const Part& p) {
        return final_cutting(p) == Cutting::cuts;
      }))
    file.problem("areas", "no part that cuts", "at least one");
}

std::string areas_text(const Bit& bit) {
  const std::map<std::string, Part> layouts = parts_of_layouts(bit);
  std::string text;
  int number = 0;
  for (const Part& part : bit.parts) {
    std::string lines;
    if (has_layout(bit, part)) {
      const Part& drawn = layouts.at(part.name);
      if (drawn.density != part.density)
        lines += fmt::format("density = {}  # kg/m3\n", part.density);
      if (drawn.cutting != final_cutting(part))
        lines += fmt::format("removal.cutting = \"{}\"\n", cutting_name(final_cutting(part)));
    }
    if (part.share < 1.0) lines += fmt::format("removal.share = {}\n", part.share);
    if (part.start) lines += start_lines(*part.start);
    if (!lines.empty())
      text +=
          fmt::format("\n[areas.part-{}]\npart = {}\n{}", ++number, toml_string(part.name), lines);
  }
  return text;
}

}  // namespace tdbd::bit
