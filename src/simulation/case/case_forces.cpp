#include "simulation/case/case_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "simulation/case/case_areas.hpp"
#include "simulation/case/case_rock.hpp"
#include "simulation/case/drilling_keys.hpp"
#include "simulation/case/force_keys.hpp"
#include "simulation/case/idle_coefficients.hpp"
#include "simulation/case/read_law.hpp"
#include "simulation/case/run_keys.hpp"
#include "simulation/case/wear_keys.hpp"

namespace tdbd::simulation {
namespace {

using bit::PartKind;

/// Whether the law of the whole run holds for a kind of part, where it knows it.
enum class FollowsRun { yes, no };

struct KindKey {
  PartKind kind;
  FollowsRun follows;
};

/// Up to what crushes the rock under a surface that does not cut, assumed.
forces::Friction crushing() {
  constexpr double friction = 0.3, over_strength = 1.5;
  forces::Friction f;
  f.stress = std::numeric_limits<double>::max();
  f.cap = over_strength;
  f.mu = friction;
  return f;
}

/// What a cutter's body bears (ours). In drilling it slides along the groove that the rim cut, and
/// carries nothing; a bit that sticks, or goes down faster than its edges cut, rests on it. Without
/// it such a bit would sink into the rock under its weight.
forces::Law cutter_body_bearing() {
  forces::Friction f = crushing();
  f.full_angle = 0.5;  // rad, far above the helix of drilling
  return f;
}

/// What a bit body bears (ours): it removes no rock, so that what is inside it presses with the whole
/// stress, whichever way the body moves.
forces::Law body_bearing() {
  forces::Friction f = crushing();
  f.full_angle = 0.0;
  return f;
}

/// What gage pads bear where the wall is the rock (WallModel::rock).
forces::Law pad_bearing(Config wall) {
  forces::Friction f = crushing();
  f.mu = wall.read(wall_keys::friction);
  f.slip_speed = wall.read(wall_keys::slip_speed);
  return f;
}

/// Where no table has a law for gage pads: they have that of the wall where the wall is the rock, and
/// none where a ring stands for them, unless they follow the law of the run.
void bear_on_wall(Config& whole, const Config& forces, const bit::Bit& bit, FollowsRun pads,
                  ForcePlan& plan) {
  if (!whole.has(wall_keys::table)) return;
  const bool has_own = forces.has(bit::kind_key(PartKind::gage_pad));
  forces::Law& of_pads = plan.laws[static_cast<std::size_t>(PartKind::gage_pad)];
  Config wall = whole.table(wall_keys::table);
  if (wall.read(wall_keys::model) != WallModel::rock) {
    if (!has_own && pads == FollowsRun::no) of_pads = forces::NoForce{};
    return;
  }
  if (!has_own) of_pads = pad_bearing(wall);
  for (const QuantityKey& key : {wall_keys::friction, wall_keys::slip_speed})
    if (has_own && wall.has(key)) {
      wall.read(key);
      wall.problem(key, "[forces.gage_pad] as well", "one of the two");
    }
  if (!bit.parts.empty() && std::ranges::none_of(bit.parts, [](const bit::Part& p) {
        return p.kind == PartKind::gage_pad && final_cutting(p) != bit::Cutting::never;
      }))
    wall.problem(wall_keys::model, "\"rock\" and a bit without gage pads",
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

/// Diameter of the cutters, m; 0: the bit has none.
double cutter_diameter(const bit::Bit& bit) {
  return bit.cutters.empty() ? 0.0 : bit.cutters.front().diameter;
}

/// A law that a table names must know the kind.
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
  if (!wrong.empty()) table.problem(force_keys::law, std::string(forces::law_name(law)), wrong);
}

/// The kinds that follow the run's law, where it knows them.
std::vector<PartKind> followers(const Config& c) {
  std::vector<PartKind> kinds;
  for (const KindKey& k : kind_keys)
    if (k.follows == FollowsRun::yes && !c.has(bit::kind_key(k.kind))) kinds.push_back(k.kind);
  return kinds;
}

/// What the tables say in vain.
void warn_of_idle(Config& c, const bit::Bit& bit, const forces::Law& common, const ForcePlan& plan,
                  std::vector<CaseWarning>& warnings) {
  const std::string name(force_keys::table.name);
  warnings = idle_coefficients(c, {name, common, read_fit(c), followers(c)}, bit);
  for (const KindKey& k : kind_keys) {
    const std::string key = bit::kind_key(k.kind);
    if (!c.has(key)) continue;
    Config table = c.table(key);
    const LawTable own{name + "." + key, law_of(plan, k.kind), read_fit(table), {k.kind}};
    std::ranges::copy(idle_coefficients(table, own, bit), std::back_inserter(warnings));
  }
}

/// Parts that rub are there to bear; without a law they do not.
void warn_of_unborne(const Config& c, const bit::Bit& bit, const ForcePlan& plan,
                     std::vector<CaseWarning>& warnings) {
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const bit::Part& p = bit.parts[i];
    if (final_cutting(p) != bit::Cutting::rubs || has_law(plan, bit, i)) continue;
    const std::string key = bit::kind_key(p.kind);
    warnings.push_back(
        {c.place(force_keys::table.name), std::string(force_keys::table.name),
         fmt::format("{} rubs, but no force acts on it: no law is given for a {}; set "
                     "forces.{}.law, or rubs = false",
                     p.name, bit::kind_words(p.kind), key)});
  }
}

/// What is made of a section belongs to a cutter whose place is known: of a table, or of meshes with
/// the cutter's frame.
bool needs_a_cutter(const ForcePlan& plan, PartKind kind) {
  return kind == PartKind::face ||
         (kind == PartKind::chamfer && plan.chamfer == ChamferMeasure::edge);
}

bool meets_rock(const bit::Part& p) { return final_cutting(p) != bit::Cutting::never; }

/// The laws that act on a part of this bit, and on which kinds: "a law that acts on a part of this bit
/// (gage pad): friction".
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

/// The law must have a part to act on, and every part what its law needs.
void require_parts(Config& c, const bit::Bit& bit, const forces::Law& common,
                   const ForcePlan& plan) {
  if (bit.parts.empty()) return;  // its own mistakes are told
  const bool is_none = std::holds_alternative<forces::NoForce>(common);
  bool acts = is_none;
  for (std::size_t i = 0; i < bit.parts.size() && !acts; ++i)
    acts = meets_rock(bit.parts[i]) &&
           law_of(plan, bit.parts[i].kind, static_cast<int>(i)).index() == common.index();
  if (!acts) c.problem(force_keys::law, std::string(forces::law_name(common)), acting_laws(c, bit));
  for (std::size_t i = 0; i < bit.parts.size(); ++i)
    if (const bit::Part& p = bit.parts[i];
        p.cutter < 0 && has_law(plan, bit, i) && needs_a_cutter(plan, p.kind))
      return c.problem("", fmt::format("{}, a part without a cutter whose place is known", p.name),
                       fmt::format("a cutter table, or the frame of its cutter (cutter_position of "
                                   "[[solids.rules]], position and rotation_vector of [[parts]]) "
                                   "with a face flat across X; or forces.{}.law = \"none\"",
                                   bit::kind_key(p.kind)));
}

/// "bit-b of cases/bits/bit-b.toml", for messages.
std::string bit_in_words(Config& whole, const bit::Bit& bit) {
  return fmt::format("{} of {}", bit.name, whole.table(bit_keys::table).read(bit_keys::file));
}

/// Sections and contact areas are what forces are made of.
void require_measures(Config& c, const bit::Bit& bit, const MeasurePlan& measure) {
  if (!bit.cutters.empty() && measure.section == SectionMeasure::off)
    c.problem("", "measure.section = \"off\"", "sections: a cutter's force comes from them");
  if (measure.contact == ContactMeasure::off)
    c.problem("", "measure.contact = \"off\"", "contact areas: forces come from them");
}

}  // namespace

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
  if (!whole.has(force_keys::table)) return plan;
  Config c = whole.table(force_keys::table);
  plan.forces = Forces::on;
  plan.cut = c.read(force_keys::cut);
  plan.chamfer = c.read(force_keys::chamfer_contact);
  plan.flat = whole.has(wear_keys::table) ? FlatMeasure::edge : FlatMeasure::triangles;
  if (c.has(force_keys::flat_contact)) plan.flat = c.read(force_keys::flat_contact);
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
  }
  plan.rock = read_formation(whole.table(rock_keys::table));
  return plan;
}

}  // namespace tdbd::simulation
