#include "bit/areas/bit_areas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bit/areas/bit_area_keys.hpp"
#include "bit/areas/read_areas.hpp"
#include "bit/cone/cone_parts.hpp"
#include "core/config/toml_text.hpp"

namespace tdbd::bit {
namespace {

/// A value per area that gives the property, and its text.
struct Values {
  std::vector<std::optional<double>> of_area;
  std::vector<std::string> shown;

  explicit Values(std::size_t areas) : of_area(areas), shown(areas) {}
};

struct GivenStart {
  StartEvent event = StartEvent::time;
  double from = 0.0;
};

Values read_densities(Areas& areas) {
  Values v(areas.tables.size());
  for (std::size_t i = 0; i < areas.tables.size(); ++i) {
    Config& c = areas.tables[i].config;
    if (!c.has(bit_area_keys::density)) continue;
    v.of_area[i] = c.read(bit_area_keys::density, 0.0);
    v.shown[i] = fmt::format("{:g} kg/m3", *v.of_area[i]);
  }
  return v;
}

Values read_cutting(Areas& areas) {
  Values v(areas.tables.size());
  for (std::size_t i = 0; i < areas.tables.size(); ++i) {
    Config& c = areas.tables[i].config;
    if (!c.has(bit_area_keys::cutting)) continue;
    const Cutting cutting = c.read(bit_area_keys::cutting, std::optional(Cutting::cuts));
    v.of_area[i] = static_cast<double>(cutting);
    v.shown[i] = '"' + cutting_name(cutting) + '"';
  }
  return v;
}

/// Equal starts have equal values: depths are positive, times negative.
Values read_starts(Areas& areas, std::vector<GivenStart>& starts) {
  Values v(areas.tables.size());
  starts.resize(areas.tables.size());
  for (std::size_t i = 0; i < areas.tables.size(); ++i) {
    Config& c = areas.tables[i].config;
    if (c.has(bit_area_keys::from_depth)) {
      starts[i] = {StartEvent::depth, c.read(bit_area_keys::from_depth, 0.0)};
      v.of_area[i] = starts[i].from;
      v.shown[i] = fmt::format("a start at {:g} m", starts[i].from);
    }
    if (!c.has(bit_area_keys::from_time)) continue;
    starts[i] = {StartEvent::time, c.read(bit_area_keys::from_time, 0.0)};
    if (v.of_area[i])
      c.problem(bit_area_keys::from_time, "removal.from_depth as well", "one of the two");
    v.of_area[i] = -starts[i].from;
    v.shown[i] = fmt::format("a start at {:g} s", starts[i].from);
  }
  return v;
}

void require_known_removal(Areas& areas) {
  for (AreaTable& area : areas.tables)
    for (const std::string& key : area.config.table("removal").given())
      if (key != "cutting" && key != "from_depth" && key != "from_time")
        area.config.problem("removal." + key, "an unknown key", "cutting, from_depth or from_time");
}

/// An area that gives nothing is one whose keys were forgotten.
void require_properties(Areas& areas, const Values& density, const Values& cutting,
                        const Values& start) {
  for (std::size_t i = 0; i < areas.tables.size(); ++i)
    if (!density.of_area[i] && !cutting.of_area[i] && !start.of_area[i])
      areas.tables[i].config.problem("", "no property",
                                     "density, removal.cutting, removal.from_depth or "
                                     "removal.from_time");
}

bool counts_elsewhere(const Part& part, const std::vector<std::string>& without_density) {
  return part.density == 0.0 &&
         std::ranges::find(without_density, part.name) == without_density.end();
}

void apply_densities(Areas& areas, const Values& v, Bit& bit,
                     std::vector<std::string>& without_density) {
  const std::vector<int> decided =
      decide_or_note(areas, bit, bit_area_keys::density, v.of_area, v.shown);
  for (std::size_t i = 0; i < areas.tables.size(); ++i) {
    const std::vector<int> parts = parts_of_rule(areas, static_cast<int>(i));
    if (!v.of_area[i] || parts.empty()) continue;
    if (std::ranges::all_of(parts, [&](int p) {
          return counts_elsewhere(bit.parts[static_cast<std::size_t>(p)], without_density);
        }))
      areas.tables[i].config.problem(
          bit_area_keys::density,
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
    std::erase(without_density, part.name);
  }
}

void apply_cutting(Areas& areas, const Values& v, Bit& bit) {
  const std::vector<int> decided =
      decide_or_note(areas, bit, bit_area_keys::cutting, v.of_area, v.shown);
  for (std::size_t p = 0; p < decided.size(); ++p) {
    if (decided[p] < 0) continue;
    Part& part = bit.parts[p];
    const auto area = static_cast<std::size_t>(decided[p]);
    part.cutting = static_cast<Cutting>(static_cast<int>(*v.of_area[area]));
    part.cutting_area = areas.rules[area].name;
    if (part.cutting == Cutting::rubs &&
        (part.kind == PartKind::face || part.kind == PartKind::chamfer))
      areas.tables[area].config.problem(
          bit_area_keys::cutting, fmt::format("\"rubs\" for {}", part.name),
          fmt::format("\"yes\" or \"no\" for a {}, whose force comes from what the face cuts",
                      kind_words(part.kind)));
  }
}

void apply_starts(Areas& areas, const Values& v, const std::vector<GivenStart>& starts, Bit& bit) {
  const std::vector<int> decided =
      decide_or_note(areas, bit, bit_area_keys::from_depth, v.of_area, v.shown);
  for (std::size_t p = 0; p < decided.size(); ++p) {
    if (decided[p] < 0) continue;
    Part& part = bit.parts[p];
    const auto area = static_cast<std::size_t>(decided[p]);
    if (part.cutting == Cutting::never)
      areas.tables[area].config.problem(
          "", fmt::format("{} for {}, which never cuts or rubs", v.shown[area], part.name),
          "removal.cutting = \"yes\" or \"rubs\" for it, or criteria without it");
    part.start = {starts[area].event, starts[area].from, part.cutting};
    part.cutting = Cutting::never;
    part.start_area = areas.rules[area].name;
  }
}

bool has_layout(const Bit& bit, const Part& part) {
  return part.cone >= 0 && !bit.cones[static_cast<std::size_t>(part.cone)].layout.shell.empty();
}

/// The parts of the cones as their layouts have them, by name.
std::map<std::string, Part> parts_of_layouts(const Bit& bit) {
  std::map<std::string, Part> parts;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    if (!bit.cones[k].layout.shell.empty())
      for (Part& part : cone_parts(bit.cones[k], static_cast<int>(k)))
        parts.emplace(part.name, std::move(part));
  return parts;
}

}  // namespace

void apply_areas(Config& file, Bit& bit, std::vector<std::string>& without_density) {
  if (!file.has(bit_area_keys::areas)) return;
  Areas areas =
      read_areas(file.table(bit_area_keys::areas), bit, fmt::format("the bit {}", bit.name));
  std::vector<GivenStart> given_starts;
  const Values density = read_densities(areas), cutting = read_cutting(areas),
               start = read_starts(areas, given_starts);
  require_known_removal(areas);
  require_properties(areas, density, cutting, start);
  apply_densities(areas, density, bit, without_density);
  apply_cutting(areas, cutting, bit);
  apply_starts(areas, start, given_starts, bit);
  if (file.problem_count() == 0 && std::ranges::none_of(bit.parts, [](const Part& p) {
        return cutting_in_the_end(p) == Cutting::cuts;
      }))
    file.problem(bit_area_keys::areas.name, "no part that cuts", "at least one");
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
      if (drawn.cutting != cutting_in_the_end(part))
        lines += fmt::format("removal.cutting = \"{}\"\n", cutting_name(cutting_in_the_end(part)));
    }
    if (part.start)
      lines += part.start->event == StartEvent::depth
                   ? fmt::format("removal.from_depth = {}  # m\n", part.start->from)
                   : fmt::format("removal.from_time = {}  # s\n", part.start->from);
    if (!lines.empty())
      text +=
          fmt::format("\n[areas.part-{}]\npart = {}\n{}", ++number, toml_string(part.name), lines);
  }
  return text;
}

}  // namespace tdbd::bit
