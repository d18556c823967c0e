#include "forces/law.hpp"

#include <fmt/format.h>

#include <array>
#include <type_traits>
#include <utility>

#include "forces/named.hpp"

namespace tdbd::forces {
namespace {

using bit::PartKind;

bool needs_diameter(const Law& law) {
  return std::visit(
      [](const auto& l) {
        return requires { l.needs_diameter; };
      },
      law);
}

/// Every law with its default coefficients, in the order of the variant.
template <std::size_t... I>
std::array<Law, sizeof...(I)> every_law(std::index_sequence<I...>) {
  return {Law(std::in_place_index<I>)...};
}
auto every_law() { return every_law(std::make_index_sequence<std::variant_size_v<Law>>()); }

}  // namespace

PartForce force(const Law& law, const PartCut& cut) {
  return std::visit(
      [&cut](const auto& l) {
        if (!l.knows(cut.kind)) return law_force(NoForce{}, cut);
        if constexpr (requires { law_pressing(l, cut); })
          if (l.presses(cut.kind)) return pressing_force(cut, law_pressing(l, cut));
        if constexpr (requires { law_force(l, cut); }) return law_force(l, cut);
        return law_force(NoForce{}, cut);
      },
      law);
}

std::optional<Pressing> pressing(const Law& law, const PartCut& cut) {
  return std::visit(
      [&cut](const auto& l) -> std::optional<Pressing> {
        if constexpr (requires { law_pressing(l, cut); })
          if (l.presses(cut.kind)) return law_pressing(l, cut);
        return std::nullopt;
      },
      law);
}

std::vector<LawField> law_fields(Law& law) {
  return std::visit(
      [](auto& l) {
        const auto coefficients = std::decay_t<decltype(l)>::coefficients();
        std::vector<LawField> fields;
        fields.reserve(coefficients.size());
        for (const auto& c : coefficients)
          fields.push_back(
              {c.key, c.unit, c.fallback, c.range, c.meaning, c.where, &(l.*c.member)});
        return fields;
      },
      law);
}

std::string_view law_name(const Law& law) {
  return std::visit([](const auto& l) { return l.name; }, law);
}

std::vector<std::string_view> law_names() {
  std::vector<std::string_view> names;
  names.reserve(std::variant_size_v<Law>);
  for (const Law& law : every_law()) names.push_back(law_name(law));
  return names;
}

Law law_named(std::string_view name) {
  const auto all = every_law();
  return item_named("force law", name, all, law_name);
}

bool knows(const Law& law, PartKind kind) {
  return std::visit([kind](const auto& l) { return l.knows(kind); }, law);
}

std::string law_problem(const Law& law, bit::PartKind kind, double diameter) {
  if (knows(law, kind)) {
    if (!needs_diameter(law) || diameter > 0.0) return {};
    return fmt::format("the law \"{}\" requires the cutter's diameter, which this {} does not have",
                       law_name(law), bit::kind_words(kind));
  }
  std::string known;
  for (const PartKind each : bit::part_kinds)
    if (knows(law, each))
      known += fmt::format("{}{}", known.empty() ? "" : ", ", bit::kind_words(each));
  return fmt::format("the law \"{}\" does not apply to {}; it applies to: {}", law_name(law),
                     bit::kind_words(kind), known);
}

}  // namespace tdbd::forces
