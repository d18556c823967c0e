#include "forces/law.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/types.hpp"

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

bool uses_strength(const Law& law, PartKind kind) {
  const bool of_one_rock =
      std::holds_alternative<NoForce>(law) || std::holds_alternative<Detournay>(law) ||
      std::holds_alternative<DepthOfCut>(law) || std::holds_alternative<Glowka>(law);
  return !of_one_rock && knows(law, kind);
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
  return find_by_name("force law", name, all, law_name);
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

namespace {

/// C d^n, fitted in lbf and inch.
struct PowerLaw {
  double C = 0.0, n = 0.0;
};

/// Force at the reference depth of the law, N.
double at_reference(const PowerLaw& p) {
  constexpr double lbf = 4.4482216152605, inch = 25.4e-3;  // N, m
  return p.C * lbf * std::pow(Glowka::reference_depth / inch, p.n);
}

Glowka glowka(const PowerLaw& normal, const PowerLaw& drag) {
  return {.Cn = at_reference(normal), .nn = normal.n, .Cd = at_reference(drag), .nd = drag.n};
}

/// The reconstructed law with given A1 and A3. Chamfers and other surfaces have assumed initial
/// values.
HansonHansen hanson_hansen(double A1, double A3) {
  return {.A1 = A1, .A3 = A3, .A5 = 1.34, .A6 = 0.6, .A7 = 0.5, .A8 = 0.3};
}

constexpr std::string_view sandia_rows =
    "fits to single-cutter rows of Sandia, 20 degrees of back rake, 0.053 m/s (github "
    "Atashnezhad/PhD_Dissertation)";

const std::array<Fit, 11>& fit_table() {
  static const std::array<Fit, 11> fits{{
      {"glowka-berea-0.5in", glowka({5925, 1.50}, {5863, 1.43}), Evidence::derived, sandia_rows},
      {"glowka-berea-0.75in", glowka({3537, 1.36}, {5281, 1.40}), Evidence::derived, sandia_rows},
      {"glowka-sierra-white-0.5in", glowka({25473, 1.64}, {47713, 1.88}), Evidence::derived,
       sandia_rows},
      {"glowka-sierra-white-0.75in-blunt", glowka({2067, 0.33}, {2346, 0.48}), Evidence::derived,
       sandia_rows},
      {"detournay-berea", Detournay{.eps = 45 * MPa, .zeta = 0.79}, Evidence::derived, sandia_rows},
      {"detournay-sierra-white", Detournay{.eps = 108 * MPa, .zeta = 1.11}, Evidence::derived,
       sandia_rows},
      {"detournay-drill-string",
       Detournay{.eps = 60 * MPa, .zeta = 0.6, .sigma = 60 * MPa, .mu = 0.6}, Evidence::seen,
       "github ulfjakob/AxialTorsionalDrillString"},
      {"detournay-hard",
       Detournay{
           .eps = 171 * MPa, .zeta = 0.7, .sigma = 60 * MPa, .mu = 0.3, .l = 2e-3, .kappa = 5},
       Evidence::seen, "\"formation 1 hard\" of a code citing Detournay et al. 2008"},
      {"hanson-hansen-sharp", hanson_hansen(0.9, 20 * degree), Evidence::derived, sandia_rows},
      {"hanson-hansen-shale-thin", hanson_hansen(3.7, 19 * degree), Evidence::derived,
       "Zijsling 1987 by Miedema's formula, 3000 to 6000 psi, cuts of 0.15 to 0.30 mm"},
      {"hanson-hansen-shale", hanson_hansen(1.5, 19 * degree), Evidence::recall,
       "thicker cuts under pressure; no source at hand"},
  }};
  return fits;
}

}  // namespace

std::span<const Fit> known_fits() { return fit_table(); }

const Fit& fit_named(std::string_view name) {
  return find_by_name("coefficients", name, known_fits(), [](const Fit& fit) { return fit.name; });
}

}  // namespace tdbd::forces
