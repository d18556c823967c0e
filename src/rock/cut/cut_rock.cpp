#include "rock/cut/cut_rock.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/sort_unique.hpp"
#include "rock/cut/star_volume.hpp"

namespace tdbd::rock {
namespace {

/// Moves a vertex to its exit from the part and records the part. Returns the removed volume, m3.
double take_vertex(Rock& rock, const SweptVertex& s, const CuttingPart& part) {
  if (rock.surface.is_boundary(s.v))
    throw RunError(fmt::format(
        "{} swept the rock's boundary at ({:.3f}, {:.3f}, {:.3f}) mm: the wall is too low or "
        "the rock too narrow for this motion",
        part.name, 1e3 * s.x_W.x(), 1e3 * s.x_W.y(), 1e3 * s.x_W.z()));
  const double volume = star_volume(rock.surface, s.v, s.x_W - rock.surface.position(s.v));
  rock.last_part[at(s.v)] = part.part;
  note_cut(rock, s.v);
  place_vertex(rock, s.v, s.x_W, Teller::mover);  // note_moves updates the near lists
  return volume;
}

void note_broken_out(std::size_t part, double volume, CutReport& report) {
  report.broken_out_by_part.resize(report.removed_by_part.size(), 0.0);
  report.broken_out_by_part[part] += volume;
}

/// Moves the vertices that the group sweeps, part after part, in ascending order of vertex numbers,
/// so that sums do not depend on the order of the index.
void carry_out(Rock& rock, const CuttingGroup& g, GroupCut& cut, CutReport& report) {
  for (auto s = cut.swept.begin(); s != cut.swept.end();) {
    const std::size_t which = s->which;
    double removed = 0.0;
    for (; s != cut.swept.end() && s->which == which; ++s) {
      const CuttingPart& part = g.parts[which];
      const Vec3 d_W = s->x_W - rock.surface.position(s->v);
      cut.moves.push_back({s->v, part.part, d_W / part.share});
      removed += take_vertex(rock, *s, part);
      if (g.leaves == Leaves::a_share || !rock.left.empty()) note_left(rock, g, part, s->v, d_W);
      cut.moved.push_back(s->v);
    }
    report.removed_by_part[at(g.parts[which].part)] += removed;
    if (g.kind == GroupKind::breakout)
      note_broken_out(static_cast<std::size_t>(g.parts[which].part), removed, report);
    report.removed += removed;
  }
  report.moved += static_cast<long>(cut.moved.size());
  sort_unique(cut.moved);
  cut.moved_in_step.insert(cut.moved_in_step.end(), cut.moved.begin(), cut.moved.end());
}

/// First pass. Every group searches the rock at the beginning of the step and plans its moves, so
/// the groups run in parallel.
void find_in_rock(Rock& rock, const CuttingBit& bit, CutWorkspace& w) {
  parallel_for(static_cast<int>(bit.groups.size()), [&](int i) {
    const CuttingGroup& g = bit.groups[at(i)];
    const GroupMotion& m = w.motions[at(i)];
    NearList& list = rock.near_lists[at(i)];
    GroupCut& cut = w.groups[at(i)];
    if (g.presence == GroupPresence::away || is_out_of_reach(rock.grid, m)) return;
    bring_up_to_date(rock.grid, {g.box_P, m.X_WP0, m.X_WP1, m.region_W}, w.list_margins, list);
    find_candidates(g, m, rock.surface, list, gaps_around_hull * w.contact_gap, cut.near);
    cut.knows_touching =
        w.contact_gap >= 0.0 && covers(list, rock.grid, widened(m.region_W, w.contact_gap));
    for (const int place : cut.near.places) cut.candidates.push_back(list.v[at(place)]);
    plan_moves(rock, g, m, cut);
  });
}

/// Keeps the candidates that a part of their own group may still sweep.
void keep_unclear(const CuttingGroup& g, GroupCut& cut) {
  const std::uint64_t all = (std::uint64_t{2} << (g.parts.size() - 1)) - 1;
  for (std::size_t i = 0; i < cut.candidates.size(); ++i)
    if (cut.clear[i].now != all) cut.unclear.push_back(cut.candidates[i]);
}

/// Later passes. Only a vertex that moved can have entered a part. It lies on the group that moved
/// it, so only groups near that one can sweep it.
void find_among_moved(const Rock& rock, const CuttingBit& bit, CutWorkspace& w) {
  for (GroupCut& cut : w.groups) cut.candidates.clear();
  const auto offer = [&](const std::vector<int>& vertices, std::size_t i) {
    if (bit.groups[i].presence == GroupPresence::away) return;
    for (const int v : vertices)
      if (!keeps_outside(bit.groups[i], w.motions[i], rock.surface.position(v)))
        w.groups[i].candidates.push_back(v);
  };
  for (std::size_t k = 0; k < w.groups.size(); ++k) {
    offer(w.groups[k].unclear, k);
    if (w.groups[k].moved.empty()) continue;
    const mesh::Box& box_W = w.motions[k].region_W.box;
    visit_overlapping(w.motion_boxes, box_W, [&](std::size_t i) {
      if (i != k && box_W.overlaps(w.motions[i].region_W.box)) offer(w.groups[k].moved, i);
    });
  }
  for (GroupCut& cut : w.groups) sort_unique(cut.candidates);
}

void begin_step(const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1, CutWorkspace& w,
                CutReport& report) {
  report.removed_by_part.assign(at(bit.part_count), 0.0);
  std::ranges::fill(report.broken_out_by_part, 0.0);
  report.removed = 0.0;
  report.candidates = report.moved = 0;
  w.groups.resize(bit.groups.size());
  for (GroupCut& cut : w.groups) {
    cut.near.places.clear();
    cut.near.touching.clear();
    cut.knows_touching = false;
    cut.candidates.clear();
    cut.swept.clear();
    cut.moved_in_step.clear();
    cut.moves.clear();
  }
  w.motions.clear();
  for (const CuttingGroup& g : bit.groups) w.motions.push_back(group_motion(g, X_WB0, X_WB1));
  resize(w.motion_boxes, w.motions.size());
  for (std::size_t i = 0; i < w.motions.size(); ++i)
    set_box(w.motion_boxes, i, w.motions[i].region_W.box);
}

/// Prefetches the data that the next group will write.
void prefetch(const Rock& rock, const CutWorkspace& w, std::size_t group) {
  if (group >= w.groups.size()) return;
  for (const SweptVertex& s : w.groups[group].swept) {
    __builtin_prefetch(&rock.surface.stars[at(s.v)]);
    __builtin_prefetch(&rock.last_part[at(s.v)]);
    __builtin_prefetch(&rock.touched[at(s.v)]);
    __builtin_prefetch(&rock.moved_in[at(s.v)]);
    rock.grid.prefetch(s.v);
  }
}

enum class Pass { first, later };

/// Processes every group in turn. Returns whether any vertex moved.
bool process_all(Rock& rock, const CuttingBit& bit, Pass pass, CutWorkspace& w, CutReport& report) {
  bool any = false;
  for (std::size_t i = 0; i < bit.groups.size(); ++i) {
    GroupCut& cut = w.groups[i];
    cut.moved.clear();
    cut.unclear.clear();
    prefetch(rock, w, i + 1);
    if (cut.candidates.empty()) continue;
    report.candidates += static_cast<long>(cut.candidates.size());
    if (pass == Pass::first)
      plan_again(
          rock, bit.groups[i], w.motions[i], [&](int v) { return is_moved_now(rock, v); }, cut);
    else
      plan_moves(rock, bit.groups[i], w.motions[i], cut);
    carry_out(rock, bit.groups[i], cut, report);
    keep_unclear(bit.groups[i], cut);
    any = any || !cut.moved.empty();
  }
  return any;
}

/// Records the new places of the vertices that the group moved.
void note_places(const Rock& rock, GroupCut& cut) {
  cut.moved_box_W = {};
  clear(cut.moved_places);
  for (const int v : cut.moved_in_step) {
    cut.moved_box_W.add(rock.surface.position(v));
    note_place(cut.moved_places, v, rock.surface.position(v));
  }
}

/// Updates one list with the moved vertices. The list contains the group's candidates of the first
/// pass. Vertices that the group moved in later passes had been moved by another group before.
void note_moves(const Rock& rock, const CutWorkspace& w, std::size_t i, NearList& list) {
  if (list.changes != w.changes_before) return;
  for (const int place : w.groups[i].near.places)
    if (const int v = list.v[at(place)]; is_moved_now(rock, v))
      set_place(list, at(place), rock.surface.position(v));
  list.changes = rock.grid.changes();
  visit_overlapping(w.moved_boxes, list.region_W.box, [&](std::size_t k) {
    const GroupCut& other = w.groups[k];
    if (k != i && other.moved_box_W.overlaps(list.region_W.box))
      note_changes(list, other.moved_places);
  });
}

/// Updates the lists with the moved vertices. Exactly one thread writes to each list.
void note_moves(Rock& rock, CutWorkspace& w) {
  resize(w.moved_boxes, w.groups.size());
  for (std::size_t k = 0; k < w.groups.size(); ++k) {
    GroupCut& cut = w.groups[k];
    std::ranges::sort(cut.moves, {}, &VertexMove::v);
    note_places(rock, cut);
    set_box(w.moved_boxes, k, cut.moved_box_W);
  }
  parallel_for(static_cast<int>(rock.near_lists.size()),
               [&](int i) { note_moves(rock, w, at(i), rock.near_lists[at(i)]); });
}

std::string first_moved(const CutWorkspace& w, const Rock& rock) {
  const auto group =
      std::ranges::find_if(w.groups, [](const GroupCut& cut) { return !cut.moved.empty(); });
  if (group == w.groups.end()) return "none";
  const int v = group->moved.front();
  const Vec3 x_W = 1e3 * rock.surface.position(v);
  return fmt::format("vertex {} at ({:.3f}, {:.3f}, {:.3f}) mm", v, x_W.x(), x_W.y(), x_W.z());
}

std::string still_moving(const CuttingBit& bit, const CutWorkspace& w, const Rock& rock) {
  std::string names;
  for (std::size_t i = 0; i < bit.groups.size(); ++i)
    for (const CuttingPart& p : bit.groups[i].parts)
      if (std::ranges::any_of(w.groups[i].moved,
                              [&](int v) { return rock.last_part[at(v)] == p.part; }))
        names += (names.empty() ? "" : ", ") + p.name;
  return names;
}

}  // namespace

void begin_at_rest(const CuttingBit& bit, const Pose& X_WB, CutWorkspace& work) {
  CutReport nothing;
  begin_step(bit, X_WB, X_WB, work, nothing);
}

void cut_rock(Rock& rock, const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1,
              CutWorkspace& work, CutReport& report) {
  begin_step(bit, X_WB0, X_WB1, work, report);
  if (!rock.left.empty()) begin_passes(rock, bit, work.motions, work.passes);
  ++rock.cuts;
  rock.near_lists.resize(bit.groups.size());
  find_in_rock(rock, bit, work);
  work.changes_before = rock.grid.changes();
  for (report.passes = 1; report.passes <= work.most_passes; ++report.passes) {
    const Pass pass = report.passes == 1 ? Pass::first : Pass::later;
    if (!process_all(rock, bit, pass, work, report)) return note_moves(rock, work);
    find_among_moved(rock, bit, work);
  }
  throw RunError(fmt::format(
      "rock vertices still move after {} passes of one step, first {}; the parts are: {}",
      work.most_passes, first_moved(work, rock), still_moving(bit, work, rock)));
}

}  // namespace tdbd::rock
