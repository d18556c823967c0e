#include "rock/cut/cut_rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/sort_unique.hpp"
#include "mesh/search/triangle_tree.hpp"

namespace tdbd::rock {
namespace {

int owner_of(const CuttingGroup& g) { return g.parts.front().part; }

auto place_of(std::vector<ResidualVertex>& left, int v, int part) {
  return std::ranges::lower_bound(left, ResidualVertex{v, part}, comes_before);
}

bool is_at(const std::vector<ResidualVertex>& left, std::vector<ResidualVertex>::const_iterator it,
           int v, int part) {
  return it != left.end() && it->v == v && it->part == part;
}

Vec3 left_of(const std::vector<ResidualVertex>& left, int v, int part) {
  const auto it = std::ranges::lower_bound(left, ResidualVertex{v, part}, comes_before);
  return is_at(left, it, v, part) ? it->left_W : Vec3(Vec3::Zero());
}

/// Whether a point is inside a part or on its surface.
bool is_in(const CuttingPart& part, const Vec3& x_P) {
  if (part.tree_P) return mesh::inside(*part.tree_P, x_P);
  for (std::size_t i = 0; i < part.solid_P.planes; ++i)
    if (mesh::normal(part.solid_P, i).dot(x_P) > part.solid_P.b[i] + part.depth) return false;
  return true;
}

bool is_in(const CuttingGroup& g, const Vec3& x_P) {
  return std::ranges::any_of(g.parts, [&](const CuttingPart& part) { return is_in(part, x_P); });
}

/// The parts whose passes include one of the vertices of an operation.
void find_parts(const std::vector<ResidualVertex>& left, const InterpolatedDisplacement& c,
                std::vector<int>& parts) {
  parts.clear();
  for (const int v : {c.v, c.from[0], c.from[1], c.from[2]})
    for (auto it = std::ranges::lower_bound(left, ResidualVertex{v, -1}, comes_before);
         it != left.end() && it->v == v; ++it)
      if (std::ranges::find(parts, it->part) == parts.end()) parts.push_back(it->part);
}

void carry(const InterpolatedDisplacement& c, std::vector<ResidualVertex>& left,
           std::vector<int>& parts) {
  find_parts(left, c, parts);
  for (const int part : parts) {
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      if (c.weight[i] > 0.0) mean += c.weight[i] * left_of(left, c.from[i], part);
    const auto it = place_of(left, c.v, part);
    if (is_at(left, it, c.v, part))
      it->left_W = mean;
    else
      left.insert(it, {c.v, part, mean});
  }
}

void find_inside(const Rock& rock, const CuttingBit& bit, const std::vector<GroupMotion>& motions,
                 PassScratch& w) {
  w.group_of_part.assign(at(bit.part_count), -1);
  for (std::size_t i = 0; i < bit.groups.size(); ++i)
    if (bit.groups[i].leaves == Residue::share_only)
      w.group_of_part[at(owner_of(bit.groups[i]))] = static_cast<int>(i);
  w.is_inside.resize(rock.left.size());
  for (std::size_t i = 0; i < rock.left.size(); ++i) {
    const ResidualVertex& l = rock.left[i];
    const int group = w.group_of_part[at(l.part)];
    w.is_inside[i] =
        group >= 0 && rock.surface.is_alive(l.v) &&
        is_in(bit.groups[at(group)], motions[at(group)].X_PW0 * rock.surface.position(l.v));
  }
}

/// Whether a neighbour in the same pass is inside the part.
bool is_beside_inside(const Rock& rock, const ResidualVertex& l,
                      const std::vector<std::uint8_t>& is_inside) {
  if (!rock.surface.is_alive(l.v)) return false;
  const mesh::VertexStar& star = rock.surface.star(l.v);
  const int* ring = rock.surface.ring(star);
  return std::any_of(ring, ring + star.size, [&](int v) {
    const auto it = std::ranges::lower_bound(rock.left, ResidualVertex{v, l.part}, comes_before);
    return is_at(rock.left, it, v, l.part) &&
           is_inside[static_cast<std::size_t>(it - rock.left.begin())] != 0;
  });
}

}  // namespace

Vec3 residue_of(const Rock& rock, const CuttingGroup& g, int v) {
  return left_of(rock.left, v, owner_of(g));
}

void record_residue(Rock& rock, const CuttingGroup& g, const CuttingPart& part, int v,
                    const Vec3& d_W) {
  const int owner = g.kind == GroupKind::parts ? owner_of(g) : -1;
  for (auto it = place_of(rock.left, v, -1); it != rock.left.end() && it->v == v; ++it) {
    if (it->part == owner) continue;
    const Vec3 rest_W = it->left_W - d_W;
    it->left_W = rest_W.dot(it->left_W) > 0.0 ? rest_W : Vec3(Vec3::Zero());
  }
  if (owner < 0 || part.share == 1.0) return;
  const Vec3 more_W = (1.0 / part.share - 1.0) * d_W;
  const auto it = place_of(rock.left, v, owner);
  if (is_at(rock.left, it, v, owner))
    it->left_W += more_W;
  else
    rock.left.insert(it, {v, owner, more_W});
}

void update_passes(Rock& rock, const CuttingBit& bit, const std::vector<GroupMotion>& motions,
                   PassScratch& w) {
  std::vector<ResidualVertex>& left = rock.left;
  for (const InterpolatedDisplacement& c : rock.carried)
    if (c.v >= 0) carry(c, left, w.parts);
  if (rock.pressed.empty()) rock.carried.clear();
  find_inside(rock, bit, motions, w);
  w.goes_on.resize(left.size());
  for (std::size_t i = 0; i < left.size(); ++i)
    w.goes_on[i] = w.is_inside[i] != 0 || is_beside_inside(rock, left[i], w.is_inside);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (w.goes_on[i] != 0) left[kept++] = left[i];
  left.resize(kept);
}

void reassign_residues(Rock& rock, const CuttingBit& bit) {
  for (ResidualVertex& l : rock.left)
    for (const CuttingGroup& g : bit.groups)
      if (g.kind == GroupKind::parts &&
          std::ranges::find(g.parts, l.part, &CuttingPart::part) != g.parts.end())
        l.part = owner_of(g);
  std::ranges::sort(rock.left, comes_before);
}

void apply_residues(Rock& rock, std::vector<Vec3>& places_W) {
  places_W.clear();
  for (const ResidualVertex& l : rock.left) {
    places_W.push_back(rock.surface.position(l.v));
    const bool is_first = places_W.size() == 1 || (&l)[-1].v != l.v;
    if (is_first) rock.surface.place(l.v, places_W.back() + l.left_W);
  }
}

void undo_residues(Rock& rock, const std::vector<Vec3>& places_W) {
  for (std::size_t i = rock.left.size(); i > 0; --i)
    rock.surface.place(rock.left[i - 1].v, places_W[i - 1]);
}

namespace {

/// Moves a vertex to its exit from the part and records the part. Returns the removed volume, m3.
double move_swept_vertex(Rock& rock, const SweptVertex& s, const CuttingPart& part) {
  if (rock.surface.is_boundary(s.v))
    throw RunError(fmt::format(
        "{} swept the rock's boundary at ({:.3f}, {:.3f}, {:.3f}) mm: the wall is too low or "
        "the rock too narrow for this motion",
        part.name, 1e3 * s.x_W.x(), 1e3 * s.x_W.y(), 1e3 * s.x_W.z()));
  const double volume = star_volume(rock.surface, s.v, s.x_W - rock.surface.position(s.v));
  rock.last_part[at(s.v)] = part.part;
  record_cut(rock, s.v);
  place_vertex(rock, s.v, s.x_W, Notify::none);  // note_moves updates the near lists
  return volume;
}

void note_broken_out(std::size_t part, double volume, CutReport& report) {
  report.broken_out_by_part.resize(report.removed_by_part.size(), 0.0);
  report.broken_out_by_part[part] += volume;
}

/// Moves the vertices that the group sweeps, part after part, in ascending order of vertex numbers,
/// so that sums do not depend on the order of the index.
void apply_planned_moves(Rock& rock, const CuttingGroup& g, GroupCut& cut, CutReport& report) {
  for (auto s = cut.swept.begin(); s != cut.swept.end();) {
    const std::size_t which = s->which;
    double removed = 0.0;
    for (; s != cut.swept.end() && s->which == which; ++s) {
      const CuttingPart& part = g.parts[which];
      const Vec3 d_W = s->x_W - rock.surface.position(s->v);
      cut.moves.push_back({s->v, part.part, d_W / part.share});
      removed += move_swept_vertex(rock, *s, part);
      if (g.leaves == Residue::share_only || !rock.left.empty())
        record_residue(rock, g, part, s->v, d_W);
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
    if (g.presence == GroupActivity::away || is_out_of_reach(rock.grid, m)) return;
    update_near_list(rock.grid, {g.box_P, m.X_WP0, m.X_WP1, m.region_W}, w.list_margins, list);
    find_candidates(g, m, rock.surface, list, gaps_around_hull * w.contact_gap, cut.near);
    cut.touching_is_complete =
        w.contact_gap >= 0.0 && covers(list, rock.grid, widened(m.region_W, w.contact_gap));
    for (const int place : cut.near.places) cut.candidates.push_back(list.v[at(place)]);
    plan_moves(rock, g, m, cut);
  });
}

/// Keeps the candidates that a part of their own group may still sweep.
void keep_not_excluded(const CuttingGroup& g, GroupCut& cut) {
  const std::uint64_t all = (std::uint64_t{2} << (g.parts.size() - 1)) - 1;
  for (std::size_t i = 0; i < cut.candidates.size(); ++i)
    if (cut.clear[i].this_pass != all) cut.not_excluded.push_back(cut.candidates[i]);
}

/// Later passes. Only a vertex that moved can have entered a part. It lies on the group that moved
/// it, so only groups near that one can sweep it.
void find_among_moved(const Rock& rock, const CuttingBit& bit, CutWorkspace& w) {
  for (GroupCut& cut : w.groups) cut.candidates.clear();
  const auto offer = [&](const std::vector<int>& vertices, std::size_t i) {
    if (bit.groups[i].presence == GroupActivity::away) return;
    for (const int v : vertices)
      if (!keeps_outside(bit.groups[i], w.motions[i], rock.surface.position(v)))
        w.groups[i].candidates.push_back(v);
  };
  for (std::size_t k = 0; k < w.groups.size(); ++k) {
    offer(w.groups[k].not_excluded, k);
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
    cut.touching_is_complete = false;
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
    cut.not_excluded.clear();
    prefetch(rock, w, i + 1);
    if (cut.candidates.empty()) continue;
    report.candidates += static_cast<long>(cut.candidates.size());
    if (pass == Pass::first)
      replan_moved(
          rock, bit.groups[i], w.motions[i], [&](int v) { return is_moved_now(rock, v); }, cut);
    else
      plan_moves(rock, bit.groups[i], w.motions[i], cut);
    apply_planned_moves(rock, bit.groups[i], cut, report);
    keep_not_excluded(bit.groups[i], cut);
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
  if (!rock.left.empty()) update_passes(rock, bit, work.motions, work.passes);
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
