#include "rock/cut/cut_rock.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/sort_unique.hpp"
#include "rock/cut/mapped_direction.hpp"
#include "rock/cut/prism.hpp"

namespace tdbd::rock {
namespace {

/// Moves a vertex that the part sweeps and notes who moved it, from where.
void take_vertex(Rock& rock, CutWorkspace& w, int v, const Vec3& x_W, const CuttingPart& part) {
  if (rock.surface.is_boundary(v))
    throw RunError(fmt::format(
        "{} swept the rock's boundary at ({:.3f}, {:.3f}, {:.3f}) mm: the wall is too low or "
        "the rock too narrow for this motion",
        part.name, 1e3 * x_W.x(), 1e3 * x_W.y(), 1e3 * x_W.z()));
  w.step_of_move[at(v)] = w.step;
  w.move_of[at(v)] = static_cast<int>(w.moves.size());
  w.moves.push_back({v, rock.surface.positions[at(v)]});
  rock.last_part[at(v)] = part.part;
  place_vertex(rock, v, x_W, Teller::mover);  // note_moves
}

/// Where vertex v was before the part at work.
const Vec3& place_before(const Rock& rock, const CutWorkspace& w, int v) {
  const auto k = static_cast<std::size_t>(w.move_of[at(v)]);
  return k < w.moves.size() && w.moves[k].v == v ? w.moves[k].from_W : rock.surface.position(v);
}

/// The triangles around the vertices that the part at work moved, each once, in the order of their
/// numbers: a sum over them does not depend on the order of the index.
void find_moved_triangles(const Rock& rock, CutWorkspace& w) {
  const mesh::Surface& s = rock.surface;
  for (const MovedVertex& m : w.moves) {
    const int c = s.corner_of[at(m.v)];
    __builtin_prefetch(&s.opposite[at(c)]);
    __builtin_prefetch(&s.triangles[at(c / 3)]);
  }
  w.triangles.clear();
  for (const MovedVertex& m : w.moves)
    mesh::visit_corners(s, m.v, [&](int c) { w.triangles.push_back(c / 3); });
  sort_unique(w.triangles);
}

/// Prism volumes of the triangles around the vertices that this part moved (4.3).
double removed_by_moves(const Rock& rock, CutWorkspace& w) {
  find_moved_triangles(rock, w);
  double sum = 0.0;
  for (const int t : w.triangles) {
    Corners from, to;
    for (std::size_t i = 0; i < 3; ++i) {
      const int v = rock.surface.triangles[at(t)][i];
      to[i] = rock.surface.position(v);
      from[i] = place_before(rock, w, v);
    }
    sum += prism_volume(from, to);
  }
  return sum;
}

/// Ur of every candidate of a group. Moving along it keeps the azimuth, so it holds for all parts.
void map_directions(const Rock& rock, const CuttingGroup& g, const GroupMotion& m,
                    const std::vector<int>& candidates, std::vector<Vec3>& directions_W) {
  directions_W.clear();
  for (const int v : candidates)
    directions_W.push_back(mapped_direction_W(g, m, rock.surface.position(v)));
}

void note_outside(Clear& clear, std::size_t part) { clear.now |= std::uint64_t{1} << part; }

void note_exit(Clear& clear, std::size_t part, bool convex) {
  const std::uint64_t bit = std::uint64_t{1} << part;
  if (convex) clear.for_good |= bit;
  clear.now = clear.for_good | bit;
}

void find_paths(const Rock& rock, const GroupMotion& m, const std::vector<int>& candidates,
                CutWorkspace& w) {
  w.paths.clear();
  for (std::size_t i = 0; i < candidates.size(); ++i)
    w.paths.push_back(
        relative_path(m.X_PW0, m.X_PW1, rock.surface.position(candidates[i]), w.directions_W[i]));
}

void process_part(Rock& rock, const CuttingGroup& g, std::size_t which, const GroupMotion& m,
                  const std::vector<int>& candidates, CutWorkspace& w, CutReport& report,
                  std::vector<int>& moved_by_group) {
  const CuttingPart& part = g.parts[which];
  w.moves.clear();
  prepare_exits(part, w.paths, w.swept);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto t = prepared_exit_distance(part, w.paths[i], w.swept);
    if (!t || *t <= 0.0) {
      note_outside(w.clear[i], which);
      continue;
    }
    const Vec3 x_W = rock.surface.position(candidates[i]) + *t * w.directions_W[i];
    take_vertex(rock, w, candidates[i], x_W, part);
    w.paths[i].q0_P = m.X_PW0 * x_W;
    w.paths[i].q1_P = m.X_PW1 * x_W;
    note_exit(w.clear[i], which, !part.tree_P);
  }
  if (w.moves.empty()) return;
  const double removed = removed_by_moves(rock, w);
  report.removed_by_part[at(part.part)] += removed;
  report.removed += removed;
  report.moved += static_cast<long>(w.moves.size());
  for (const MovedVertex& moved : w.moves) moved_by_group.push_back(moved.v);
}

/// First pass: every group searches the rock as the step found it, so groups search in parallel.
void find_in_rock(Rock& rock, const CuttingBit& bit, CutWorkspace& w) {
  parallel_for(static_cast<int>(bit.groups.size()), [&](int i) {
    const CuttingGroup& g = bit.groups[at(i)];
    const GroupMotion& m = w.motions[at(i)];
    NearList& list = rock.near_lists[at(i)];
    NearGroup& near = w.near[at(i)];
    w.candidates[at(i)].clear();
    near.places.clear();
    w.knows_touching[at(i)] = 0;
    if (is_out_of_reach(rock.grid, m)) return;
    bring_up_to_date(rock.grid, {g.box_P, m.X_WP0, m.X_WP1, m.region_W}, w.list_margins, list);
    find_candidates(g, m, rock.surface.positions, list, gaps_around_hull * w.contact_gap, near);
    w.knows_touching[at(i)] =
        w.contact_gap >= 0.0 && covers(list, rock.grid, widened(m.region_W, w.contact_gap)) ? 1 : 0;
    for (const int place : near.places) w.candidates[at(i)].push_back(list.v[at(place)]);
  });
}

/// Keeps the candidates that a part of their own group may still sweep.
void keep_unclear(const CuttingGroup& g, const std::vector<int>& candidates,
                  const std::vector<Clear>& clear, std::vector<int>& unclear) {
  const std::uint64_t all = (std::uint64_t{2} << (g.parts.size() - 1)) - 1;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (clear[i].now != all) unclear.push_back(candidates[i]);
}

/// Later passes: only what moved can have entered a part, and it lies on the group that moved it,
/// so only groups near that one can sweep it.
void find_among_moved(const Rock& rock, const CuttingBit& bit, CutWorkspace& w) {
  for (std::size_t i = 0; i < bit.groups.size(); ++i) {
    w.candidates[i].clear();
    const mesh::Box& box_W = w.motions[i].region_W.box;
    for (std::size_t k = 0; k < bit.groups.size(); ++k) {
      const std::vector<int>& among = k == i ? w.unclear_by_group[k] : w.moved_by_group[k];
      if (among.empty() || !box_W.overlaps(w.motions[k].region_W.box)) continue;
      for (const int v : among)
        if (!keeps_outside(bit.groups[i], w.motions[i], rock.surface.position(v)))
          w.candidates[i].push_back(v);
    }
    sort_unique(w.candidates[i]);
  }
}

void begin_step(const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1, CutWorkspace& w,
                CutReport& report) {
  report.removed_by_part.assign(at(bit.part_count), 0.0);
  report.removed = 0.0;
  report.candidates = report.moved = 0;
  ++w.step;
  w.moved_by_group.resize(bit.groups.size());
  w.unclear_by_group.resize(bit.groups.size());
  w.candidates.resize(bit.groups.size());
  w.near.resize(bit.groups.size());
  w.knows_touching.resize(bit.groups.size());
  w.moved_in_step.resize(bit.groups.size());
  w.moved_boxes_W.resize(bit.groups.size());
  for (auto& moved : w.moved_in_step) moved.clear();
  w.motions.clear();
  for (const CuttingGroup& g : bit.groups) w.motions.push_back(group_motion(g, X_WB0, X_WB1));
}

/// Prefetches what the next group will read of its candidates, while this one is at work.
void prefetch(const Rock& rock, const CutWorkspace& w, std::size_t group) {
  if (group >= w.candidates.size()) return;
  for (const int v : w.candidates[group]) {
    __builtin_prefetch(&rock.surface.positions[at(v)]);
    __builtin_prefetch(&rock.surface.corner_of[at(v)]);
    __builtin_prefetch(&rock.last_part[at(v)]);
    __builtin_prefetch(&rock.touched[at(v)]);
    __builtin_prefetch(&w.move_of[at(v)]);
    __builtin_prefetch(&w.step_of_move[at(v)]);
    rock.grid.prefetch(v);
  }
}

/// Every part in turn. Returns whether anything moved.
bool process_all(Rock& rock, const CuttingBit& bit, CutWorkspace& w, CutReport& report) {
  bool any = false;
  for (std::size_t i = 0; i < bit.groups.size(); ++i) {
    w.moved_by_group[i].clear();
    w.unclear_by_group[i].clear();
    prefetch(rock, w, i + 1);
    if (w.candidates[i].empty()) continue;
    report.candidates += static_cast<long>(w.candidates[i].size());
    map_directions(rock, bit.groups[i], w.motions[i], w.candidates[i], w.directions_W);
    find_paths(rock, w.motions[i], w.candidates[i], w);
    w.clear.assign(w.candidates[i].size(), {});
    for (std::size_t part = 0; part < bit.groups[i].parts.size(); ++part)
      process_part(rock, bit.groups[i], part, w.motions[i], w.candidates[i], w, report,
                   w.moved_by_group[i]);
    keep_unclear(bit.groups[i], w.candidates[i], w.clear, w.unclear_by_group[i]);
    sort_unique(w.moved_by_group[i]);
    w.moved_in_step[i].insert(w.moved_in_step[i].end(), w.moved_by_group[i].begin(),
                              w.moved_by_group[i].end());
    any = any || !w.moved_by_group[i].empty();
  }
  return any;
}

/// Updates the lists with what moved. A group's first candidates are in its list; what it moved
/// in later passes had been moved by another group before.
void note_moves(Rock& rock, CutWorkspace& w) {
  for (std::size_t i = 0; i < rock.near_lists.size(); ++i) {
    NearList& list = rock.near_lists[i];
    if (list.changes != w.changes_before) continue;
    for (const int place : w.near[i].places)
      if (const int v = list.v[at(place)]; w.step_of_move[at(v)] == w.step)
        set_place(list, at(place), rock.surface.position(v));
    list.changes = rock.grid.changes();
  }
  for (std::size_t k = 0; k < w.moved_in_step.size(); ++k) {
    mesh::Box& box_W = w.moved_boxes_W[k];
    box_W = {};
    for (const int v : w.moved_in_step[k]) box_W.add(rock.surface.position(v));
    for (std::size_t i = 0; i < rock.near_lists.size(); ++i) {
      NearList& list = rock.near_lists[i];
      if (i == k || !box_W.overlaps(list.region_W.box)) continue;
      for (const int v : w.moved_in_step[k])
        if (is_between(list.region_W.slabs, rock.surface.position(v)))
          note_moved(list, v, rock.surface.position(v));
    }
  }
}

std::string first_moved(const CutWorkspace& w, const Rock& rock) {
  const auto group =
      std::ranges::find_if(w.moved_by_group, [](const auto& v) { return !v.empty(); });
  if (group == w.moved_by_group.end()) return "none";
  const Vec3& x_W = rock.surface.position(group->front());
  return fmt::format("vertex {} at ({:.3f}, {:.3f}, {:.3f}) mm", group->front(), 1e3 * x_W.x(),
                     1e3 * x_W.y(), 1e3 * x_W.z());
}

std::string still_moving(const CuttingBit& bit, const CutWorkspace& w, const Rock& rock) {
  std::string names;
  for (std::size_t i = 0; i < bit.groups.size(); ++i)
    for (const CuttingPart& p : bit.groups[i].parts)
      if (std::ranges::any_of(w.moved_by_group[i],
                              [&](int v) { return rock.last_part[at(v)] == p.part; }))
        names += (names.empty() ? "" : ", ") + p.name;
  return names;
}

}  // namespace

void cut_rock(Rock& rock, const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1,
              CutWorkspace& work, CutReport& report) {
  begin_step(bit, X_WB0, X_WB1, work, report);
  work.move_of.resize(rock.surface.positions.size(), 0);
  work.step_of_move.resize(rock.surface.positions.size(), 0);
  rock.near_lists.resize(bit.groups.size());
  find_in_rock(rock, bit, work);
  work.changes_before = rock.grid.changes();
  for (report.passes = 1; report.passes <= work.most_passes; ++report.passes) {
    if (!process_all(rock, bit, work, report)) return note_moves(rock, work);
    find_among_moved(rock, bit, work);
  }
  throw RunError(fmt::format(
      "rock vertices still move after {} passes of one step, first {}; the parts are: {}",
      work.most_passes, first_moved(work, rock), still_moving(bit, work, rock)));
}

}  // namespace tdbd::rock
