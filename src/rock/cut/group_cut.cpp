#include "rock/cut/group_cut.hpp"

#include <algorithm>
#include <tuple>

#include "rock/cut/mapped_direction.hpp"

namespace tdbd::rock {
namespace {

void note_outside(Clear& clear, std::size_t part) { clear.now |= std::uint64_t{1} << part; }

void note_exit(Clear& clear, std::size_t part, bool convex) {
  const std::uint64_t bit = std::uint64_t{1} << part;
  if (convex) clear.for_good |= bit;
  clear.now = clear.for_good | bit;
}

/// Ur and the path of every candidate at work. Moving along Ur keeps the azimuth, so it holds for
/// all parts.
void find_paths(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut) {
  for (const std::size_t i : cut.at_work) {
    const Vec3& x_W = rock.surface.position(cut.candidates[i]);
    cut.directions_W[i] = mapped_direction_W(g, m, x_W);
    cut.paths[i] = relative_path(m.X_PW0, m.X_PW1, x_W, cut.directions_W[i]);
    cut.places_W[i] = x_W;
    cut.clear[i] = {};
  }
}

void plan_part(const CuttingGroup& g, std::size_t which, const GroupMotion& m, GroupCut& cut) {
  const CuttingPart& part = g.parts[which];
  prepare_exits(part, cut.paths, cut.exits);
  for (const std::size_t i : cut.at_work) {
    const auto t = prepared_exit_distance(part, cut.paths[i], cut.exits);
    if (!t || *t <= 0.0) {
      note_outside(cut.clear[i], which);
      continue;
    }
    Vec3& x_W = cut.places_W[i];
    x_W += *t * cut.directions_W[i];
    cut.swept.push_back({which, cut.candidates[i], x_W});
    cut.paths[i].q0_P = m.X_PW0 * x_W;
    cut.paths[i].q1_P = m.X_PW1 * x_W;
    note_exit(cut.clear[i], which, !part.tree_P);
  }
}

/// Every vertex leaves the whole group at once and is clear of all parts then.
void plan_whole(const CuttingGroup& g, GroupCut& cut) {
  prepare_exits(g.whole->solid, cut.paths, cut.exits);
  for (const std::size_t i : cut.at_work) {
    for (std::size_t which = 0; which < g.parts.size(); ++which) note_outside(cut.clear[i], which);
    const auto x = prepared_whole_exit(*g.whole, cut.paths[i], cut.exits);
    if (!x) continue;
    cut.places_W[i] += x->t * cut.directions_W[i];
    cut.swept.push_back({x->part, cut.candidates[i], cut.places_W[i]});
  }
}

}  // namespace

void plan_at_work(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut) {
  find_paths(rock, g, m, cut);
  if (g.whole) plan_whole(g, cut);
  for (std::size_t which = 0; !g.whole && which < g.parts.size(); ++which)
    plan_part(g, which, m, cut);
  std::ranges::sort(cut.swept, {}, [](const SweptVertex& s) { return std::tuple(s.which, s.v); });
}

void plan_moves(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut) {
  const std::size_t n = cut.candidates.size();
  cut.swept.clear();
  cut.clear.resize(n);
  cut.directions_W.resize(n);
  cut.paths.resize(n);
  cut.places_W.resize(n);
  cut.at_work.resize(n);
  for (std::size_t i = 0; i < n; ++i) cut.at_work[i] = i;
  if (n > 0) plan_at_work(rock, g, m, cut);
}

}  // namespace tdbd::rock
