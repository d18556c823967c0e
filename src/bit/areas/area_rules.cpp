#include "bit/areas/area_rules.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace tdbd::bit {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool is_of_gage_row(const Bit& bit, const Part& part) {
  if (part.cone < 0 || part.row < 0) return false;
  const std::vector<ToothRow>& rows = bit.cones[at(part.cone)].layout.rows;
  return at(part.row) < rows.size() && rows[at(part.row)].place == RowPlace::gage;
}

/// Whether a criterion is absent or equal to the part's own value.
template <class T>
bool meets(const std::optional<T>& criterion, const T& own) {
  return !criterion || *criterion == own;
}

/// Adds a pair of rules unless it is already there.
void add_disagreement(int first, int second, int part, std::vector<Disagreement>& all) {
  const auto same = [&](const Disagreement& d) { return d.first == first && d.second == second; };
  if (std::ranges::none_of(all, same)) all.push_back({first, second, part});
}

}  // namespace

std::string zone_of(const Bit& bit, const Part& part) {
  if (part.cutter >= 0) return bit.cutters[at(part.cutter)].zone;
  return part.kind == PartKind::gage_pad || is_of_gage_row(bit, part) ? "gage" : "";
}

bool selects(const AreaSelector& s, const Bit& bit, const Part& part) {
  if (!meets(s.kind, part.kind) || !meets(s.cone, part.cone + 1) || !meets(s.row, part.row + 1))
    return false;
  if (s.blade && (part.cutter < 0 || bit.cutters[at(part.cutter)].blade != *s.blade)) return false;
  if (s.zone && (s.zone->empty() || zone_of(bit, part) != *s.zone)) return false;
  return meets(s.part, part.name) && (!s.names || fits(*s.names, part.name));
}

int rank_of(const AreaSelector& s) {
  int rank = 0, weight = 1;
  for (const bool given :
       {s.kind.has_value(), s.zone.has_value(), s.blade.has_value(), s.cone.has_value(),
        s.row.has_value(), s.names.has_value(), s.part.has_value()}) {
    rank += given ? weight : 0;
    weight *= 2;
  }
  return rank;
}

RulesOfParts rules_of_parts(const Bit& bit, std::span<const AreaRule> rules) {
  std::vector<int> by_rank(rules.size());
  for (std::size_t i = 0; i < rules.size(); ++i) by_rank[i] = static_cast<int>(i);
  std::ranges::stable_sort(by_rank, {}, [&](int i) { return rank_of(rules[at(i)].selector); });
  RulesOfParts of_parts(bit.parts.size());
  for (std::size_t p = 0; p < bit.parts.size(); ++p)
    for (const int i : by_rank)
      if (selects(rules[at(i)].selector, bit, bit.parts[p])) of_parts[p].push_back(i);
  return of_parts;
}

Decision decide(const RulesOfParts& of_parts, std::span<const AreaRule> rules,
                std::span<const std::optional<double>> values) {
  Decision d;
  d.rule.assign(of_parts.size(), -1);
  for (std::size_t p = 0; p < of_parts.size(); ++p) {
    int& best = d.rule[p];
    for (const int i : of_parts[p]) {
      if (!values[at(i)]) continue;
      const bool ties =
          best >= 0 && rank_of(rules[at(i)].selector) == rank_of(rules[at(best)].selector);
      if (!ties) best = i;
    }
    for (const int i : of_parts[p])
      if (values[at(i)] && rank_of(rules[at(i)].selector) == rank_of(rules[at(best)].selector) &&
          *values[at(i)] != *values[at(best)])
        add_disagreement(best, i, static_cast<int>(p), d.disagreements);
  }
  return d;
}

}  // namespace tdbd::bit
