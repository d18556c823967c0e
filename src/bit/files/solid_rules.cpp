#include "bit/files/solid_rules.hpp"

#include <limits>
#include <utility>

#include "bit/files/mesh_keys.hpp"
#include "bit/files/part_keys.hpp"
#include "core/text.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {
namespace {

std::optional<Pose> read_frame(Config& c) {
  if (!c.has(solid_rule_keys::cutter_position) && !c.has(solid_rule_keys::cutter_rotation_vector))
    return {};
  Pose X_BC;
  X_BC.p = c.read(solid_rule_keys::cutter_position);
  X_BC.R = rotation::exp(c.read(solid_rule_keys::cutter_rotation_vector));
  return X_BC;
}

SolidRule read_rule(Config& c) {
  SolidRule rule;
  rule.match = c.read(solid_rule_keys::match);
  if (c.has(solid_rule_keys::name)) rule.name = c.read(solid_rule_keys::name);
  if (rule.name && !is_part_name(*rule.name))
    c.problem(solid_rule_keys::name, '"' + *rule.name + '"',
              "letters, digits, - and _, with / between");
  if (c.has(solid_rule_keys::kind)) rule.kind = part_kind_named(c.read(solid_rule_keys::kind));
  if (c.has(solid_rule_keys::cutting)) rule.cutting = c.read(solid_rule_keys::cutting);
  if (c.has(solid_rule_keys::rubs)) rule.rubs = c.read(solid_rule_keys::rubs);
  if (c.has(solid_rule_keys::density)) rule.density = c.read(solid_rule_keys::density);
  if (c.has(solid_rule_keys::group)) rule.group = static_cast<int>(c.read(solid_rule_keys::group));
  rule.X_BC = read_frame(c);
  if (c.has(solid_rule_keys::update_direction))
    rule.update_direction_B = read_direction(c, Vec3::UnitZ());
  return rule;
}

template <class T>
void lay_over(std::optional<T>& below, const std::optional<T>& above) {
  if (above) below = above;
}

}  // namespace

std::vector<SolidRule> read_rules(Config& solids) {
  std::vector<SolidRule> rules;
  std::vector<Config> tables = solids.tables(solid_rule_keys::table);
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

}  // namespace tdbd::bit
