#include "bit/areas/area_rules.hpp"

#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "bit/generate.hpp"

namespace tdbd::bit::area_rules_test {

/// A few parts of every kind, without meshes: cutters on two blades and in two zones, pads, a body
/// and two cones with an inner and a gage row.
Bit small_bit() {
  Bit bit;
  const auto add = [&](std::string name, PartKind kind) -> Part& {
    Part& part = bit.parts.emplace_back();
    part.name = std::move(name);
    part.kind = kind;
    return part;
  };
  for (int i = 0; i < 4; ++i) {
    Cutter c;
    c.id = i + 1;
    c.blade = i % 2 + 1;
    c.zone = i < 2 ? "nose" : "shoulder";
    bit.cutters.push_back(c);
    add(fmt::format("cutter-{}/face", c.id), PartKind::face).cutter = i;
    add(fmt::format("cutter-{}/body", c.id), PartKind::cutter_body).cutter = i;
  }
  add("gage-pad-1", PartKind::gage_pad);
  add("bit-body", PartKind::bit_body);
  for (int k = 0; k < 2; ++k) {
    Cone& cone = bit.cones.emplace_back();
    cone.layout.rows.resize(2);
    cone.layout.rows[1].place = RowPlace::gage;
    add(fmt::format("cone-{}/body", k + 1), PartKind::cone).cone = k;
    for (int row = 0; row < 2; ++row) {
      Part& tooth = add(fmt::format("cone-{}/row-{}/tooth-1", k + 1, row + 1), PartKind::tooth);
      tooth.cone = k;
      tooth.row = row;
    }
  }
  return bit;
}

std::vector<std::string> selected(const AreaSelector& s) {
  const Bit bit = small_bit();
  std::vector<std::string> names;
  for (const Part& part : bit.parts)
    if (selects(s, bit, part)) names.push_back(part.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(AreaRules, select_by_every_criterion) {
  EXPECT_EQ(selected({.kind = PartKind::gage_pad}), Names{"gage-pad-1"});
  EXPECT_EQ(selected({.zone = "shoulder"}),
            (Names{"cutter-3/face", "cutter-3/body", "cutter-4/face", "cutter-4/body"}));
  EXPECT_EQ(selected({.zone = "gage"}),
            (Names{"gage-pad-1", "cone-1/row-2/tooth-1", "cone-2/row-2/tooth-1"}));
  EXPECT_EQ(selected({.kind = PartKind::face, .blade = 2}),
            (Names{"cutter-2/face", "cutter-4/face"}));
  EXPECT_EQ(selected({.cone = 2}),
            (Names{"cone-2/body", "cone-2/row-1/tooth-1", "cone-2/row-2/tooth-1"}));
  EXPECT_EQ(selected({.row = 1}), (Names{"cone-1/row-1/tooth-1", "cone-2/row-1/tooth-1"}));
  EXPECT_EQ(selected({.names = "*-1/face"}), Names{"cutter-1/face"});
  EXPECT_EQ(selected({.part = "bit-body"}), Names{"bit-body"});
}

TEST(AreaRules, without_a_zone_select_nothing_by_zone) {
  EXPECT_TRUE(selected({.zone = ""}).empty());
}

/// Each of these outranks all before it.
TEST(AreaRules, rank_from_the_general_to_the_particular) {
  const AreaSelector rising[] = {{.kind = PartKind::face},
                                 {.zone = "nose"},
                                 {.kind = PartKind::face, .zone = "nose"},
                                 {.blade = 1},
                                 {.kind = PartKind::face, .zone = "nose", .blade = 1},
                                 {.cone = 1},
                                 {.row = 1},
                                 {.cone = 1, .row = 1},
                                 {.names = "*"},
                                 {.kind = PartKind::face, .names = "*"},
                                 {.part = "bit-body"}};
  for (std::size_t i = 1; i < std::size(rising); ++i)
    EXPECT_LT(rank_of(rising[i - 1]), rank_of(rising[i])) << i;
}

/// Two patterns overlap on one part, for which a third area decides.
TEST(AreaRules, of_equal_rank_disagree_only_where_they_decide) {
  const Bit bit = small_bit();
  const std::vector<AreaRule> rules{{"faces", "", {.names = "*/face"}},
                                    {"firsts", "", {.names = "cutter-1/*"}},
                                    {"one", "", {.part = "cutter-1/face"}}};
  const RulesOfParts of_parts = rules_of_parts(bit, rules);
  const auto clash = [&](std::optional<double> a, std::optional<double> b,
                         std::optional<double> c) {
    return decide(of_parts, rules, std::vector{a, b, c}).disagreements;
  };
  ASSERT_EQ(clash(1.0, 2.0, {}).size(), 1u);
  EXPECT_EQ(clash(1.0, 2.0, {}).front().first, 0);
  EXPECT_EQ(clash(1.0, 2.0, {}).front().second, 1);
  EXPECT_EQ(bit.parts[static_cast<std::size_t>(clash(1.0, 2.0, {}).front().part)].name,
            "cutter-1/face");
  EXPECT_TRUE(clash(1.0, 1.0, {}).empty());
  EXPECT_TRUE(clash(1.0, {}, {}).empty());
  EXPECT_TRUE(clash(1.0, 2.0, 3.0).empty());
}

template <class T>
std::optional<T> maybe(T value) {
  if (*rc::gen::inRange(0, 3) > 0) return {};
  return value;
}

/// Criteria of one part, so that most areas select some, with a pattern that may not match it.
AreaSelector any_selector(const Bit& bit) {
  static const std::vector<std::string> patterns{"*", "cutter-*", "*/face", "cone-?/*", "*-1*"};
  const Part& part = bit.parts[*rc::gen::inRange<std::size_t>(0, bit.parts.size())];
  AreaSelector s;
  s.kind = maybe(part.kind);
  if (const std::string zone = zone_of(bit, part); !zone.empty()) s.zone = maybe(zone);
  if (part.cutter >= 0) s.blade = maybe(bit.cutters[static_cast<std::size_t>(part.cutter)].blade);
  if (part.cone >= 0) s.cone = maybe(part.cone + 1);
  if (part.row >= 0) s.row = maybe(part.row + 1);
  s.names = maybe(*rc::gen::elementOf(patterns));
  s.part = maybe(part.name);
  return s;
}

/// The criteria of an area as texts, by their place in the list from the general to the particular.
std::map<int, std::string> texts_of(const AreaSelector& s) {
  std::map<int, std::string> texts;
  if (s.kind) texts[0] = kind_name(*s.kind);
  if (s.zone) texts[1] = *s.zone;
  if (s.blade) texts[2] = std::to_string(*s.blade);
  if (s.cone) texts[3] = std::to_string(*s.cone);
  if (s.row) texts[4] = std::to_string(*s.row);
  if (s.names) texts[5] = *s.names;
  if (s.part) texts[6] = *s.part;
  return texts;
}

/// The same of a part, read off its name.
std::map<int, std::string> texts_of(const Bit& bit, const Part& part) {
  std::map<int, std::string> texts{{0, kind_name(part.kind)}, {5, part.name}, {6, part.name}};
  std::smatch m;
  if (std::regex_match(part.name, m, std::regex("cutter-([0-9]+)/.*"))) {
    const Cutter& c = bit.cutters[std::stoul(m[1]) - 1];
    texts[1] = c.zone;
    texts[2] = std::to_string(c.blade);
  }
  if (std::regex_match(part.name, m, std::regex("cone-([0-9]+)/.*"))) texts[3] = m[1];
  if (std::regex_match(part.name, m, std::regex(".*/row-([0-9]+)/.*"))) texts[4] = m[1];
  if (part.name == "gage-pad-1" || texts[4] == "2") texts[1] = "gage";
  return texts;
}

bool selects_by_texts(const std::map<int, std::string>& area, std::map<int, std::string> part) {
  for (const auto& [place, text] : area) {
    if (place == 5) {
      const std::string stars = std::regex_replace(text, std::regex("\\*"), ".*");
      const std::string all = std::regex_replace(stars, std::regex("\\?"), ".");
      if (!std::regex_match(part[place], std::regex(all))) return false;
    } else if (part[place] != text) {
      return false;
    }
  }
  return true;
}

/// Whether `a` is more particular than `b`: -1, 0, 1.
int compare(const std::map<int, std::string>& a, const std::map<int, std::string>& b) {
  for (int place = 6; place >= 0; --place)
    if (a.count(place) != b.count(place)) return a.count(place) > b.count(place) ? 1 : -1;
  return 0;
}

/// A slow twin, by texts and regular expressions: an area decides if none beats it.
RC_GTEST_PROP(AreaRules, agree_with_a_twin_by_texts, ()) {
  const Bit bit = small_bit();
  std::vector<AreaRule> rules;
  std::vector<std::optional<double>> values;
  for (int left = *rc::gen::inRange(0, 20); left > 0; --left) {
    rules.push_back({"", "", any_selector(bit)});
    values.emplace_back();
    if (*rc::gen::inRange(0, 5) > 0) values.back() = *rc::gen::inRange(0, 3);
  }
  const Decision fast = decide(rules_of_parts(bit, rules), rules, values);
  std::map<std::pair<int, int>, int> clashes;
  for (std::size_t p = 0; p < bit.parts.size(); ++p) {
    std::vector<int> best;
    for (std::size_t i = 0; i < rules.size(); ++i) {
      const auto area = texts_of(rules[i].selector);
      if (!values[i] || !selects_by_texts(area, texts_of(bit, bit.parts[p]))) continue;
      const int against =
          best.empty() ? 1
                       : compare(area, texts_of(rules[static_cast<std::size_t>(best[0])].selector));
      if (against > 0) best.clear();
      if (against >= 0) best.push_back(static_cast<int>(i));
    }
    RC_ASSERT(fast.rule[p] == (best.empty() ? -1 : best[0]));
    for (std::size_t k = 1; k < best.size(); ++k)
      if (*values[static_cast<std::size_t>(best[k])] != *values[static_cast<std::size_t>(best[0])])
        clashes.emplace(std::pair(best[0], best[k]), static_cast<int>(p));
  }
  RC_ASSERT(fast.disagreements.size() == clashes.size());
  for (const Disagreement& d : fast.disagreements)
    RC_ASSERT(clashes.at({d.first, d.second}) == d.part);
}

}  // namespace tdbd::bit::area_rules_test
