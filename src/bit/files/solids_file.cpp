#include "bit/files/solids_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/files/bit_parts.hpp"
#include "bit/files/file_checks.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "mesh/files/solids.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {
namespace {

constexpr const char* solids_wanted = "closed meshes with outward normals (STL, OBJ, PLY or OFF)";

std::vector<mesh::Solid> read_file(Config& c, const SolidSettings& s) {
  if (s.file.empty() || contradicts_unit(c, s.file, s.unit)) return {};
  try {
    std::vector<std::string> warnings;
    std::vector<mesh::Solid> solids = mesh::read_solids(s.file, s.unit, 0.0, &warnings);
    for (const std::string& w : warnings) c.doubt("file", w);
    report_mesh_faults(c, "file", s.file, solids, solids_wanted);
    return solids;
  } catch (const InputError& e) {
    c.problem("file", e.what(), solids_wanted);
    return {};
  }
}

std::vector<std::string> names_of(const std::vector<mesh::Solid>& solids) {
  std::vector<std::string> names;
  names.reserve(solids.size());
  for (const mesh::Solid& solid : solids) names.push_back(solid.name);
  return names;
}

/// Records a mistake for a rule that matches nothing; it is probably misspelt.
void require_matches(Config& c, const std::vector<SolidRule>& rules,
                     const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const auto is_fit = [&](const std::string& name) { return fits(rules[i].match, name); };
    if (names.empty() || std::any_of(names.begin(), names.end(), is_fit)) continue;
    const auto near = nearest_name(rules[i].match, names);
    c.problem(
        fmt::format("rules[{}].match", i), fmt::format("\"{}\", no solid's", rules[i].match),
        fmt::format("a pattern that fits one of {} solids{}", names.size(),
                    near ? "; did you mean " + *near + "?" : " (" + names.front() + ", ...)"));
  }
}

/// The text before the last / in the name of a cutter's part; empty for any other part.
std::string cutter_name(const Part& part) {
  const std::size_t end = part.name.rfind('/');
  return belongs_to_a_cutter(part.kind) && end != std::string::npos ? part.name.substr(0, end) : "";
}

Vec3 direction_of(const SolidRule& rule, const Part& part, DirectionRule directions,
                  InsideRule inside) {
  if (rule.update_direction_B) return *rule.update_direction_B;
  if (part.kind == PartKind::gage_pad) return Vec3::UnitX();
  if (!belongs_to_a_cutter(part.kind) || !rule.X_BC) return Vec3::UnitZ();
  return update_direction(*rule.X_BC, directions, inside);
}

/// Makes a part from a solid, its rules and its name.
Part part_of(const SolidRule& rule, mesh::Solid solid, PartKind kind) {
  Part part;
  part.name = rule.name.value_or(solid.name);
  part.kind = kind;
  part.mesh_P = std::move(solid.mesh);
  const bool may_cut = kind != PartKind::bit_body && kind != PartKind::cone;
  part.cutting = rule.cutting.value_or(may_cut) ? Cutting::cuts
                 : rule.rubs.value_or(false)    ? Cutting::rubs
                                                : Cutting::never;
  part.density = rule.density.value_or(0.0);
  return part;
}

/// Records mistakes of the parts as a whole.
void check_parts(Config& file, const std::vector<Part>& parts) {
  std::map<std::string, int> count;
  for (const Part& part : parts) {
    if (!is_part_name(part.name))
      file.problem("solids.file", "a solid named \"" + part.name + '"',
                   "letters, digits, - and _, with / between, or a rule that gives it a name");
    if (++count[part.name] == 2)
      file.problem("solids.file", "a second solid \"" + part.name + '"',
                   "a name of its own for each, or a rule that gives it one");
  }
  const auto cuts = [](const Part& p) { return p.cutting == Cutting::cuts; };
  if (!parts.empty() && std::none_of(parts.begin(), parts.end(), cuts))
    file.problem("solids", "no part that cuts", "at least one");
}

SolidRule read_rule(Config& c) {
  SolidRuleSettings s;
  read_fields(c, s);
  SolidRule rule;
  rule.match = s.match;
  rule.name = s.name;
  if (rule.name && !is_part_name(*rule.name))
    c.problem("name", '"' + *rule.name + '"', "letters, digits, - and _, with / between");
  if (s.kind) rule.kind = part_kind_named(*s.kind);
  rule.cutting = s.cutting;
  rule.rubs = s.rubs;
  rule.density = s.density;
  rule.group = s.group;
  if (c.has("cutter_position") || c.has("cutter_rotation_vector"))
    rule.X_BC = {rotation::exp(s.cutter_rotation_vector), s.cutter_position};
  read_fields(c, rule.labels);
  if (c.has("update_direction")) rule.update_direction_B = read_direction(c, Vec3::UnitZ());
  return rule;
}

template <class T>
void lay_over(std::optional<T>& below, const std::optional<T>& above) {
  if (above) below = above;
}

}  // namespace

std::vector<SolidRule> read_rules(Config& solids) {
  std::vector<SolidRule> rules;
  std::vector<Config> tables = solids.tables(SolidRuleSettings::table);
  rules.reserve(tables.size());
  for (Config& c : tables) rules.push_back(read_rule(c));
  return rules;
}

SolidRule rule_for(const std::vector<SolidRule>& rules, const std::string& name) {
  SolidRule all;
  all.match = name;
  for (const SolidRule& rule : rules) {
    if (!fits(rule.match, name)) continue;
    lay_over(all.name, rule.name);
    lay_over(all.kind, rule.kind);
    lay_over(all.cutting, rule.cutting);
    lay_over(all.rubs, rule.rubs);
    lay_over(all.density, rule.density);
    lay_over(all.group, rule.group);
    lay_over(all.X_BC, rule.X_BC);
    lay_over(all.update_direction_B, rule.update_direction_B);
    lay_over(all.labels.blade, rule.labels.blade);
    lay_over(all.labels.zone, rule.labels.zone);
    lay_over(all.labels.under_exposure, rule.labels.under_exposure);
    lay_over(all.labels.wear, rule.labels.wear);
  }
  return all;
}

std::optional<PartKind> kind_of_name(const std::string& name) {
  const std::pair<const char*, PartKind> known[] = {{"cutter-*/face", PartKind::face},
                                                    {"cutter-*/chamfer", PartKind::chamfer},
                                                    {"cutter-*/land", PartKind::chamfer},
                                                    {"cutter-*/cse", PartKind::cse},
                                                    {"cutter-*/body", PartKind::cutter_body},
                                                    {"gage-pad-*", PartKind::gage_pad},
                                                    {"bit-body", PartKind::bit_body},
                                                    {"cone-*/row-*/tooth-*", PartKind::tooth},
                                                    {"cone-*/body", PartKind::cone},
                                                    {"leg-*/insert-*", PartKind::gage_pad},
                                                    {"leg-*", PartKind::bit_body}};
  for (const auto& [pattern, kind] : known)
    if (fits(pattern, name)) return kind;
  return {};
}

std::vector<Cone> read_solid_cones(Config& solids) {
  std::vector<Cone> cones;
  for (Config& c : solids.tables(SolidConeSettings::table)) {
    SolidConeSettings s;
    read_fields(c, s);
    Cone& cone = s.cone;
    cone.X_BK = cone_pose(cone.layout, 0.0);
    cones.push_back(cone);
  }
  return cones;
}

int cone_of(const std::vector<Cone>& cones, const std::string& part) {
  const auto at = std::find_if(cones.begin(), cones.end(),
                               [&](const Cone& cone) { return part.starts_with(cone.name + "/"); });
  return at == cones.end() ? -1 : static_cast<int>(at - cones.begin());
}

std::string cone_text_of(const Cone& cone) {
  const ConeLayout& c = cone.layout;
  return fmt::format(
      "\n[[solids.cones]]\nname = {}\nazimuth = {}  # rad\njournal_angle = {}  # rad\noffset = {}  "
      "# m\nskew = {}  # rad\napex = {}  # m\nfoot_height = {}  # m\nrolling_ratio = {}\n",
      toml_string(cone.name), c.azimuth, c.journal_angle, c.offset, c.skew, c.apex, c.foot_height,
      rolling_ratio_of_gage_row(cone));
}

PartsFromFiles read_solid_parts(Config& file, DirectionRule directions, InsideRule inside,
                                Densities densities) {
  const auto settings = read_table<SolidSettings>(file);
  Config c = file.table(SolidSettings::table);
  std::vector<mesh::Solid> solids = read_file(c, settings);
  const std::vector<SolidRule> rules = read_rules(c);
  require_matches(c, rules, names_of(solids));
  PartsFromFiles read;
  read.cones = read_solid_cones(c);
  std::map<std::string, int> groups;
  for (mesh::Solid& solid : solids) {
    const SolidRule rule = rule_for(rules, solid.name);
    const auto kind = rule.kind ? rule.kind : kind_of_name(rule.name.value_or(solid.name));
    if (!kind)
      c.problem("file", fmt::format("a solid \"{}\" whose name does not say its kind", solid.name),
                "a name like cutter-1/face, gage-pad-1, bit-body or cone-1/row-1/tooth-1, or a "
                "rule [[solids.rules]] that fits it and gives its kind");
    Part part = part_of(rule, std::move(solid), kind.value_or(PartKind::bit_body));
    if (const std::string cutter = cutter_name(part); !cutter.empty())
      part.group = groups.try_emplace(cutter, static_cast<int>(groups.size())).first->second;
    part.group = rule.group.value_or(part.group);
    part.cone = cone_of(read.cones, part.name);
    if (!rule.density) read.without_density.push_back(part.name);
    part.update_direction_B = direction_of(rule, part, directions, inside);
    read.has_direction.push_back(rule.update_direction_B || rule.X_BC ||
                                 !belongs_to_a_cutter(part.kind));
    read.frames.push_back(rule.X_BC);
    read.labels.push_back(rule.labels);
    read.parts.push_back(std::move(part));
  }
  for (std::size_t i = 0; i < read.cones.size(); ++i)
    if (Cone& cone = read.cones[i]; cone.rolling_ratio == 0.0)
      cone.rolling_ratio = rolling_ratio_of_parts(cone, static_cast<int>(i), read.parts);
  check_parts(file, read.parts);
  if (unit_check_enabled(file)) unit_error(c, "unit", read.parts, settings.unit);
  if (densities == Densities::required && !read.without_density.empty())
    c.problem("rules", "no density of " + listed(read.without_density), expected_density);
  return read;
}

}  // namespace tdbd::bit
