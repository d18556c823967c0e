
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "forces/law.hpp"
#include "simulation/case/drilling_settings.hpp"
#include "simulation/case/force_settings.hpp"
#include "simulation/case/rock_settings.hpp"

namespace tdbd::simulation {
namespace {

using bit::PartKind;

/// Whether the law of the whole run applies to a kind of part, if the law knows the kind.
enum class FollowsRun { yes, no };

struct KindKey {
  PartKind kind;
  FollowsRun follows;
};

/// The stress that crushes the rock under a surface that does not cut, assumed.
forces::Friction crushing() {
  constexpr double friction = 0.3, over_strength = 1.5;
  forces::Friction f;
  f.stress = std::numeric_limits<double>::max();
  f.cap = over_strength;
  f.mu = friction;
  return f;
}

/// The default law of cutter bodies [+]. In drilling, a body slides along the groove that the rim
/// cut, and carries nothing. A bit that sticks, or advances faster than its edges cut, rests on the
/// bodies. Without this law such a bit would sink into the rock under its weight.
forces::Law cutter_body_bearing() {
  forces::Friction f = crushing();
  f.full_angle = 0.5;  // rad, far above the helix angle of drilling
  return f;
}

/// The default law of bit bodies [+]. A body removes no rock, so the part of it that is inside rock
/// presses with the full stress in every direction of motion.
forces::Law body_bearing() {
  forces::Friction f = crushing();
  f.full_angle = 0.0;
  return f;
}

/// The default law of gage pads if the wall is the rock (WallModel::rock).
forces::Law pad_bearing(const dynamics::Wall& wall) {
  forces::Friction f = crushing();
  f.mu = wall.friction;
  f.slip_speed = wall.slip_speed;
  return f;
}

/// The law of gage pads if no table gives one: that of the wall if the wall is the rock, and none
/// if a ring represents it, unless they follow the law of the run.
void bear_on_wall(Config& whole, const Config& forces, const bit::Bit& bit, FollowsRun pads,
                  ForcePlan& plan) {
  if (!whole.has(WallSettings::table)) return;
  const bool has_own = forces.has(bit::kind_key(PartKind::gage_pad));
  forces::Law& of_pads = plan.laws[static_cast<std::size_t>(PartKind::gage_pad)];
  Config wall = whole.table(WallSettings::table);
  WallSettings settings;
  FieldReader reader(wall);
  settings.visit_model(reader);
  if (settings.model != WallModel::rock) {
    if (!has_own && pads == FollowsRun::no) of_pads = forces::NoForce{};
    return;
  }
  if (!has_own) {
    settings.visit_friction(reader);
    of_pads = pad_bearing(settings.wall);
  }
  for (const char* key : {"friction", "slip_speed"})
    if (has_own && wall.has(key)) wall.problem(key, "[forces.gage_pad] as well", "one of the two");
  if (!bit.parts.empty() && std::ranges::none_of(bit.parts, [](const bit::Part& p) {
        return p.kind == PartKind::gage_pad && final_cutting(p) != bit::Cutting::never;
      }))
    wall.problem("model", "\"rock\" and a bit without gage pads",
                 "gage pads that bear on the wall ([gage_pads] of the bit file), or \"ring\"");
}

/// Kinds in the order of PartKind.
constexpr std::array<KindKey, bit::part_kinds.size()> kind_keys{
    {{PartKind::face, FollowsRun::yes},
     {PartKind::chamfer, FollowsRun::yes},
     {PartKind::cse, FollowsRun::yes},
     {PartKind::cutter_body, FollowsRun::no},
     {PartKind::gage_pad, FollowsRun::yes},
     {PartKind::bit_body, FollowsRun::yes},
     {PartKind::cone, FollowsRun::yes},
     {PartKind::tooth, FollowsRun::yes}}};

/// Diameter of the cutters, m; 0 if the bit has none.
double cutter_diameter(const bit::Bit& bit) {
  return bit.cutters.empty() ? 0.0 : bit.cutters.front().diameter;
}

/// Records a mistake if the law of a table does not know the kind.
void read_law_of(Config& c, const KindKey& k, const forces::Law& common, const bit::Bit& bit,
                 ForcePlan& plan) {
  forces::Law& law = plan.laws[static_cast<std::size_t>(k.kind)];
  const bool follows = k.follows == FollowsRun::yes &&
                       forces::law_problem(common, k.kind, cutter_diameter(bit)).empty();
  law = follows ? common : own_law_of(k.kind);
  const std::string key = bit::kind_key(k.kind);
  if (!c.has(key)) return;
  Config table = c.table(key);
  law = read_law(table, std::string(forces::law_name(law)));
  const std::string wrong = forces::law_problem(law, k.kind, cutter_diameter(bit));
  if (!wrong.empty()) table.problem("law", std::string(forces::law_name(law)), wrong);
}

/// Returns the kinds that follow the law of the run, if it knows them.
std::vector<PartKind> followers(const Config& c) {
  std::vector<PartKind> kinds;
  for (const KindKey& k : kind_keys)
    if (k.follows == FollowsRun::yes && !c.has(bit::kind_key(k.kind))) kinds.push_back(k.kind);
  return kinds;
}

/// Warns about settings of the tables that have no effect.
void warn_of_idle(Config& c, const bit::Bit& bit, const forces::Law& common, const ForcePlan& plan,
                  std::vector<CaseWarning>& warnings) {
  const std::string name(ForcePlan::table.name);
  warnings = idle_coefficients(c, {name, common, read_fit(c), followers(c)}, bit);
  for (const KindKey& k : kind_keys) {
    const std::string key = bit::kind_key(k.kind);
    if (!c.has(key)) continue;
    Config table = c.table(key);
    const LawTable own{name + "." + key, law_of(plan, k.kind), read_fit(table), {k.kind}};
    std::ranges::copy(idle_coefficients(table, own, bit), std::back_inserter(warnings));
  }
}

/// Warns about parts that rub but have no law, because they are meant to carry load.
void warn_of_unborne(const Config& c, const bit::Bit& bit, const ForcePlan& plan,
                     std::vector<CaseWarning>& warnings) {
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const bit::Part& p = bit.parts[i];
    if (final_cutting(p) != bit::Cutting::rubs || has_law(plan, bit, i)) continue;
    const std::string key = bit::kind_key(p.kind);
    warnings.push_back(
        {c.place(ForcePlan::table.name), std::string(ForcePlan::table.name),
         fmt::format("{} rubs, but no force acts on it: no law is given for a {}; set "
                     "forces.{}.law, or rubs = false",
                     p.name, bit::kind_words(p.kind), key)});
  }
}

bool meets_rock(const bit::Part& p) { return final_cutting(p) != bit::Cutting::never; }

/// The setting by which a case chooses a strength of the rock on purpose: properties, beds, or
/// --set; empty if it only names a rock. Every case with forces has to name one, as a label if its
/// law has coefficients for that rock.
std::string chosen_strength(Config& rock) {
  const std::string material = "material";
  if (rock.has("layers")) return "layers";
  if (rock.has(material) && !rock.is_text(material)) return material + ".unconfined_strength";
  return rock.place(material).starts_with("--set") ? material : "";
}

/// Warns if the case chooses a strength on which no force depends. Parts that bear load only by
/// accident (bodies, and pads without a law or a wall of rock) do not count.
void warn_of_unused_strength(Config& whole, const Config& forces, const bit::Bit& bit,
                             const ForcePlan& plan, std::vector<CaseWarning>& warnings) {
  Config rock = whole.table(RockStart::table);
  const std::string chosen = chosen_strength(rock);
  if (chosen.empty()) return;
  const auto counts = [&](PartKind kind) {
    const bool is_pad = kind == PartKind::gage_pad;
    const bool by_accident = is_pad || kind == PartKind::bit_body || kind == PartKind::cutter_body;
    return !by_accident || forces.has(bit::kind_key(kind)) ||
           (is_pad && whole.has(WallSettings::table));
  };
  std::vector<std::string> laws;
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const bit::Part& p = bit.parts[i];
    if (!meets_rock(p) || !has_law(plan, bit, i) || !counts(p.kind)) continue;
    const forces::Law& law = law_of(plan, p.kind, static_cast<int>(i));
    if (forces::uses_strength(law, p.kind)) return;
    const std::string name(forces::law_name(law));
    if (std::ranges::count(laws, name) == 0) laws.push_back(name);
  }
  if (laws.empty()) return;
  warnings.push_back(
      {rock.place(chosen), fmt::format("{}.{}", RockStart::table.name, chosen),
       fmt::format(
           "has no effect: the law {} does not depend on the strength of the rock; change "
           "its coefficients, or use hanson-hansen, thin-cut (faces) or indentation (teeth)",
           fmt::join(laws, ", "))});
}

/// Quantities that follow from a section belong to a cutter whose position is known: from a table,
/// or from meshes with the cutter's frame.
bool needs_a_cutter(const ForcePlan& plan, PartKind kind) {
  return kind == PartKind::face ||
         (kind == PartKind::chamfer && plan.chamfer == ChamferMeasure::edge);
}

/// Names the laws that act on a part of this bit, and the kinds: "a law that acts on a part of this
/// bit (gage pad): friction".
std::string acting_laws(const Config& c, const bit::Bit& bit) {
  std::vector<PartKind> kinds = followers(c);
  std::erase_if(kinds, [&](PartKind kind) {
    return std::ranges::none_of(
        bit.parts, [&](const bit::Part& p) { return p.kind == kind && meets_rock(p); });
  });
  std::string words, names;
  for (const PartKind kind : kinds)
    words += fmt::format("{}{}", words.empty() ? "" : ", ", bit::kind_words(kind));
  for (const std::string_view name : forces::law_names()) {
    const forces::Law law = forces::law_named(name);
    const bool acts = std::ranges::any_of(kinds, [&](PartKind kind) {
      return forces::law_problem(law, kind, cutter_diameter(bit)).empty();
    });
    if (acts && !std::holds_alternative<forces::NoForce>(law))
      names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  }
  if (names.empty()) return "none, and a law for a kind of part in a table [forces.KIND]";
  return fmt::format("a law that acts on a part of this bit ({}): {}", words, names);
}

/// Records mistakes: a law without a part to act on, and a part without an input that its law
/// requires.
void require_parts(Config& c, const bit::Bit& bit, const forces::Law& common,
                   const ForcePlan& plan) {
  if (bit.parts.empty()) return;  // its mistakes are already recorded
  const bool is_none = std::holds_alternative<forces::NoForce>(common);
  bool acts = is_none;
  for (std::size_t i = 0; i < bit.parts.size() && !acts; ++i)
    acts = meets_rock(bit.parts[i]) &&
           law_of(plan, bit.parts[i].kind, static_cast<int>(i)).index() == common.index();
  if (!acts) c.problem("law", std::string(forces::law_name(common)), acting_laws(c, bit));
  for (std::size_t i = 0; i < bit.parts.size(); ++i)
    if (const bit::Part& p = bit.parts[i];
        p.cutter < 0 && has_law(plan, bit, i) && needs_a_cutter(plan, p.kind))
      return c.problem("", fmt::format("{}, a part without a cutter whose place is known", p.name),
                       fmt::format("a cutter table, or the frame of its cutter (cutter_position of "
                                   "[[solids.rules]], position and rotation_vector of [[parts]]) "
                                   "with a face flat across X; or forces.{}.law = \"none\"",
                                   bit::kind_key(p.kind)));
}

/// The name of a bit in messages: "bit-b of cases/bits/bit-b.toml".
std::string bit_in_words(Config& whole, const bit::Bit& bit) {
  return fmt::format("{} of {}", bit.name, read_table<BitSettings>(whole).file);
}

/// Forces are computed from sections and contact areas.
void require_measures(Config& c, const bit::Bit& bit, const MeasurePlan& measure) {
  if (!bit.cutters.empty() && measure.section == SectionMeasure::off)
    c.problem("", "measure.section = \"off\"",
              "sections, from which the forces of cutters are computed");
  if (measure.contact == ContactMeasure::off)
    c.problem("", "measure.contact = \"off\"", "contact areas, from which forces are computed");
}

}  // namespace

std::vector<std::string_view> LawChoice::fit_names() {
  std::vector<std::string_view> names;
  for (const forces::Fit& fit : forces::known_fits()) names.push_back(fit.name);
  return names;
}

std::string LawChoice::law_of_fit(const std::string& name) {
  return name.empty() ? "" : std::string(forces::law_name(forces::fit_named(name).law));
}

QuantityKey key_of(const forces::LawField& field) {
  return {.name = field.key,
          .unit = field.unit,
          .fallback = field.fallback,
          .range = field.range,
          .meaning = field.meaning};
}

std::optional<forces::Law> read_fit(Config& c) {
  if (!c.has("coefficients")) return std::nullopt;
  LawChoice choice;
  read_fields(c, choice);
  return forces::fit_named(choice.coefficients).law;
}

forces::Law read_law(Config& c, const std::string& usual) {
  LawChoice choice;
  choice.law = usual;
  read_fields(c, choice);
  const std::optional<forces::Law> fit = read_fit(c);
  if (fit && choice.law != forces::law_name(*fit))
    c.problem("law", choice.law,
              "the law of forces.coefficients, " + std::string(forces::law_name(*fit)));
  forces::Law law = fit.value_or(forces::law_named(choice.law));
  for (const forces::LawField& f : forces::law_fields(law))
    *f.value = c.read(key_of(f), fit ? std::optional(*f.value) : f.fallback);
  return law;
}

forces::Law own_law_of(PartKind kind) {
  switch (kind) {
    case PartKind::cutter_body:
      return cutter_body_bearing();
    case PartKind::gage_pad:
      return crushing();
    case PartKind::bit_body:
      return body_bearing();
    default:
      return forces::NoForce{};
  }
}

bool follows_the_run(PartKind kind) {
  return kind_keys[static_cast<std::size_t>(kind)].follows == FollowsRun::yes;
}

ForcePlan read_forces(Config& whole, const bit::Bit& bit, const MeasurePlan& measure,
                      std::vector<CaseWarning>& warnings) {
  ForcePlan plan;
  if (!whole.has(ForcePlan::table)) return plan;
  Config c = whole.table(ForcePlan::table);
  plan.forces = Forces::on;
  plan.flat = whole.has(WearPlan::table) ? FlatMeasure::edge : FlatMeasure::triangles;
  read_fields(c, plan);
  const forces::Law common = read_law(c, "");
  for (const KindKey& k : kind_keys) read_law_of(c, k, common, bit, plan);
  const bool know_pads =
      forces::law_problem(common, PartKind::gage_pad, cutter_diameter(bit)).empty();
  bear_on_wall(whole, c, bit, know_pads ? FollowsRun::yes : FollowsRun::no, plan);
  std::vector<CaseWarning> area_warnings;
  read_force_areas(c, bit, bit_in_words(whole, bit), plan, area_warnings);
  require_parts(c, bit, common, plan);
  require_measures(c, bit, measure);
  if (c.problem_count() == 0) {
    warn_of_idle(c, bit, common, plan, warnings);
    std::ranges::move(area_warnings, std::back_inserter(warnings));
    warn_of_unborne(whole, bit, plan, warnings);
    warn_of_unused_strength(whole, c, bit, plan, warnings);
  }
  plan.rock = read_formation(whole.table(RockStart::table));
  return plan;
}

}  // namespace tdbd::simulation
