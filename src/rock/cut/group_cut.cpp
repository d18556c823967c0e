#include "rock/cut/group_cut.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "mesh/surface.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/cut/plane_strip.hpp"
#include "rock/cut/sieves.hpp"
#include "rock/cut/wide_exits.hpp"

namespace tdbd::rock {
namespace {

Vec3 from_segment(const bit::Segment& s, const Vec3& q) {
  const Vec3 along = s.to - s.from, from = q - s.from;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp(from.dot(along) / length2, 0.0, 1.0) : 0.0;
  return from - share * along;
}

/// U at azimuth 0. `radial_D`: unit vector from D's axis to x.
Vec3 normal_direction(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W,
                      const Vec3& radial_D) {
  const Vec3 q_P = 0.5 * (m.X_PW0 * x_W + m.X_PW1 * x_W);
  const Vec3 n_D = m.R_DB * (g.X_BP1.R * from_segment(*g.core_P, q_P));
  const Vec3 u(std::max(0.0, n_D.dot(radial_D)), 0.0, std::max(0.0, n_D.z()));
  const double length = u.norm();
  return length > 0.0 ? Vec3(u / length) : g.update_direction_B;
}

}  // namespace

Vec3 mapped_direction_W(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W) {
  const Vec3 x_D = m.X_DW1 * x_W;
  const double rho = std::sqrt(x_D.x() * x_D.x() + x_D.y() * x_D.y());
  const double c = rho > 0.0 ? x_D.x() / rho : 1.0, s = rho > 0.0 ? x_D.y() / rho : 0.0;
  const Vec3 U = g.core_P ? normal_direction(g, m, x_W, Vec3(c, s, 0.0)) : g.update_direction_B;
  return m.R_WD1 * Vec3(c * U.x() - s * U.y(), s * U.x() + c * U.y(), U.z());
}

namespace {

void exclude_part(Excluded& clear, std::size_t part) {
  clear.this_pass |= std::uint64_t{1} << part;
}

void note_exit(Excluded& clear, std::size_t part, bool convex) {
  const std::uint64_t bit = std::uint64_t{1} << part;
  if (convex) clear.all_passes |= bit;
  clear.this_pass = clear.all_passes | bit;
}

/// Computes the update direction Ur and the path of every candidate at work. A move along Ur does
/// not change the azimuth, so both are valid for all parts of the group.
void find_paths(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut) {
  for (const std::size_t i : cut.candidates_to_plan) {
    Vec3 x_W = rock.surface.position(cut.candidates[i]);
    if (g.leaves == Residue::share_only) {
      cut.left_W[i] = residue_of(rock, g, cut.candidates[i]);
      x_W += cut.left_W[i];
    }
    cut.directions_W[i] = mapped_direction_W(g, m, x_W);
    cut.paths[i] = relative_path(m.X_PW0, m.X_PW1, x_W, cut.directions_W[i]);
    cut.places_W[i] = x_W;
    cut.clear[i] = {};
  }
}

/// Moves a candidate as the group sees it, and plans the corresponding move of the vertex.
void plan_move(const CuttingGroup& g, std::size_t which, std::size_t i, double t, GroupCut& cut) {
  Vec3& x_W = cut.places_W[i];
  x_W += t * cut.directions_W[i];
  cut.swept.push_back({which, cut.candidates[i], x_W});
  if (g.leaves == Residue::nothing) return;
  cut.left_W[i] += (1.0 - g.parts[which].share) * t * cut.directions_W[i];
  cut.swept.back().x_W -= cut.left_W[i];
}

/// Fills cut.alone with the candidates at work that a solid may sweep. Most candidates lie on a
/// surface that moves away from them. Then one plane keeps their whole path outside, often the same
/// plane as for the previous candidate.
void find_swept_by(const CuttingPart& part, GroupCut& cut) {
  cut.alone.clear();
  if (part.tree_P)
    return cut.alone.assign(cut.candidates_to_plan.begin(), cut.candidates_to_plan.end());
  const mesh::ConvexSolid& solid = part.solid_P;
  std::size_t plane = 0;
  for (const std::size_t i : cut.candidates_to_plan) {
    const RelativePath& p = cut.paths[i];
    if (is_beside_path(solid, plane, p.q0_P, p.q1_P, part.depth)) continue;
    const std::size_t beside = plane_beside_path(solid, p.q0_P, p.q1_P, part.depth);
    if (beside == solid.b.size())
      cut.alone.push_back(i);
    else
      plane = beside;
  }
}

void plan_part(const CuttingGroup& g, std::size_t which, const GroupMotion& m, GroupCut& cut) {
  const CuttingPart& part = g.parts[which];
  for (const std::size_t i : cut.candidates_to_plan) exclude_part(cut.clear[i], which);
  find_swept_by(part, cut);
  if (cut.alone.empty()) return;
  prepare_exits(part, boxes_around(cut.paths, cut.alone), cut.exits);
  for (const std::size_t i : cut.alone) {
    const auto t = prepared_exit_distance(part, cut.paths[i], cut.exits);
    if (!t || *t <= 0.0) continue;
    plan_move(g, which, i, *t, cut);
    cut.paths[i].q0_P = m.X_PW0 * cut.places_W[i];
    cut.paths[i].q1_P = m.X_PW1 * cut.places_W[i];
    note_exit(cut.clear[i], which, !part.tree_P);
  }
}

/// Plans exits from the whole group. Afterwards every vertex is clear of all parts.
void plan_union_exits(const CuttingGroup& g, GroupCut& cut) {
  prepare_exits(g.whole->solid, boxes_around(cut.paths, cut.candidates_to_plan), cut.exits);
  for (const std::size_t i : cut.candidates_to_plan) {
    for (std::size_t which = 0; which < g.parts.size(); ++which) exclude_part(cut.clear[i], which);
    const auto x = prepared_union_exit(*g.whole, cut.paths[i], cut.exits);
    if (!x) continue;
    plan_move(g, x->part, i, x->t, cut);
  }
}

bool can_plan_fours(const CuttingGroup& g) {
  return g.whole && g.whole->sectors && !g.core_P && g.leaves == Residue::nothing;
}

/// Plans the candidates at work from index `begin` on, at most four.
void plan_four(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, std::size_t begin,
               GroupCut& cut) {
  const std::size_t count = std::min(lanes, cut.candidates_to_plan.size() - begin);
  const std::uint64_t all = (std::uint64_t{2} << (g.parts.size() - 1)) - 1;
  std::array<const Vec3*, lanes> x_W{};
  for (std::size_t l = 0; l < lanes; ++l)
    x_W[l] = &rock.surface.position(
        cut.candidates[cut.candidates_to_plan[begin + std::min(l, count - 1)]]);
  WidePaths paths;
  WideExits exits;
  find_paths(g, m, x_W, paths);
  find_exits(*g.whole->sectors, paths, g.whole->solid.depth, exits);
  for (std::size_t l = 0; l < count; ++l) {
    const std::size_t i = cut.candidates_to_plan[begin + l];
    cut.clear[i] = {all, 0};
    if ((exits.missed >> l & 1U) != 0) continue;
    if ((exits.found >> l & 1U) == 0) {
      cut.alone.push_back(i);
      continue;
    }
    const auto x = union_exit(*g.whole, path_of(paths, l), crossing_of(exits, l));
    if (x)
      cut.swept.push_back({x->part, cut.candidates[i], *x_W[l] + x->t * lane_of(paths.u_W, l)});
  }
}

/// Equivalent to find_paths and plan_union_exits, four vertices at a time. Vertices that need the scalar
/// search stay in cut.candidates_to_plan.
void plan_union_exits_by_fours(const Rock& rock, const CuttingGroup& g, const GroupMotion& m,
                               GroupCut& cut) {
  cut.alone.clear();
  for (std::size_t i = 0; i < cut.candidates_to_plan.size(); i += lanes)
    plan_four(rock, g, m, i, cut);
  std::swap(cut.candidates_to_plan, cut.alone);
}

}  // namespace

void plan_candidates(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut) {
  if (can_plan_fours(g)) plan_union_exits_by_fours(rock, g, m, cut);
  find_paths(rock, g, m, cut);
  if (g.whole && !cut.candidates_to_plan.empty()) plan_union_exits(g, cut);
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
  if (g.leaves == Residue::share_only) cut.left_W.resize(n);
  cut.candidates_to_plan.resize(n);
  for (std::size_t i = 0; i < n; ++i) cut.candidates_to_plan[i] = i;
  if (n > 0) plan_candidates(rock, g, m, cut);
}

namespace {

/// Returns a plane of the hull that has both points outside by `slack`, or the number of columns if
/// there is none.
TDBD_WIDE std::size_t separating_plane(const mesh::ConvexSolid& h, const Vec3& q0, const Vec3& q1,
                                       double slack) {
  for (std::size_t i = 0; i < h.b.size(); i += lanes) {
    WidePlanes planes;
    load(h, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide out0 = x * q0.x() + y * q0.y() + z * q0.z() - b;
    const Wide out1 = x * q1.x() + y * q1.y() + z * q1.z() - b;
    const Wide out = out0 < out1 ? out0 : out1;
    for (std::size_t l = 0; l < lanes; ++l)
      if (out[l] >= slack) return i + l;
  }
  return h.b.size();
}

/// Appends the places of the pack at `from` whose bit is set to the run.
void keep(unsigned bits, std::size_t from, PlaceBatch& r) {
  for (; bits != 0; bits &= bits - 1U, ++r.count) {
    const auto i = from + static_cast<std::size_t>(std::countr_zero(bits));
    for (auto* frame : {&r.start, &r.end})
      for (auto& column : *frame) column[r.count] = column[i];
    r.place[r.count] = r.place[i];
  }
}

/// Bit mask of the places of a pack at i that come before the end.
unsigned filled(std::size_t i, std::size_t end) {
  return (1U << std::min(end - i, single_lanes)) - 1U;
}

/// Removes the places that the first planes of the hull reject, which is most of them.
void keep_inside_first_planes(const Sieve& sieve, PlaceBatch& r) {
  const std::size_t end = std::exchange(r.count, 0);
  for (std::size_t i = 0; i < end; i += single_lanes) {
    SievePass in;
    sieve_pack(r, i, sieve, SingleSolid::run, in);
    keep((in.swept | in.touched) & filled(i, end), i, r);
  }
}

/// Calls visit_swept(place in the list) and visit_touched for the places of the run that pass, and
/// empties the run.
template <class Swept, class Touched>
void flush_batch(const Sieve& sieve, PlaceBatch& r, Swept& visit_swept, Touched& visit_touched) {
  keep_inside_first_planes(sieve, r);
  for (std::size_t i = 0; i < r.count; i += single_lanes) {
    SievePass in;
    sieve_pack(r, i, sieve, sieve.hull_P.planes, in);
    for (unsigned bits = in.swept & filled(i, r.count); bits != 0; bits &= bits - 1U)
      visit_swept(at(r.place[i + static_cast<std::size_t>(std::countr_zero(bits))]));
    for (unsigned bits = in.touched & filled(i, r.count); bits != 0; bits &= bits - 1U)
      visit_touched(at(r.place[i + static_cast<std::size_t>(std::countr_zero(bits))]));
  }
  r.count = 0;
}

/// Applies flush_batch to a whole list.
template <class Swept, class Touched>
void sift(const NearList& list, const Sieve& sieve, Swept&& visit_swept, Touched&& visit_touched) {
  PlaceBatch run;
  for (std::size_t first = 0; first * single_lanes < list.v.size(); first += single_lanes)
    for (unsigned packs = balls_near(list.balls, first, sieve); packs != 0; packs &= packs - 1U) {
      const std::size_t begin =
          single_lanes * (first + static_cast<std::size_t>(std::countr_zero(packs)));
      keep(put_into_frames(list, begin, sieve, run), run.count, run);
      if (run.count + single_lanes > PlaceBatch::most)
        flush_batch(sieve, run, visit_swept, visit_touched);
    }
  flush_batch(sieve, run, visit_swept, visit_touched);
}

void find_around_hull(const CuttingGroup& g, const GroupMotion& m, const mesh::Surface& surface,
                      const NearList& list, double gap, NearGroup& near) {
  sift(
      list, make_sieve(g, m, list, gap),
      [&](std::size_t i) {
        if (!keeps_outside(g, m, surface.position(list.v[i])))
          near.places.push_back(static_cast<int>(i));
      },
      [&](std::size_t i) { near.touching.push_back(list.v[i]); });
}

/// Only places within rounding of a bound are tested in double precision.
void find_around_cylinder(const CuttingGroup& g, const GroupMotion& m, const mesh::Surface& surface,
                          const NearList& list, double gap, NearGroup& near) {
  const std::size_t count = sieve_round(list, make_round_sieve(g, m, list, gap), near.packs);
  for (std::size_t k = 0; k < count; ++k) {
    const SievedPack& pack = near.packs[k];
    for (unsigned bits = pack.swept; bits != 0; bits &= bits - 1U) {
      const int lane = std::countr_zero(bits), place = pack.begin + lane;
      const bool is_certain = (pack.certain >> lane & 1U) != 0;
      if (is_certain || !keeps_outside(g, m, surface.position(list.v[at(place)])))
        near.places.push_back(place);
    }
    for (unsigned bits = pack.touched; bits != 0; bits &= bits - 1U)
      near.touching.push_back(list.v[at(pack.begin + std::countr_zero(bits))]);
  }
}

}  // namespace

void find_candidates(const CuttingGroup& g, const GroupMotion& m, const mesh::Surface& surface,
                     const NearList& list, double gap, NearGroup& near) {
  near.places.clear();
  near.touching.clear();
  if (g.radius > 0.0)
    find_around_cylinder(g, m, surface, list, gap, near);
  else
    find_around_hull(g, m, surface, list, gap, near);
}

bool keeps_outside(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W) {
  if (!is_between(m.region_W.slabs, x_W)) return true;
  const Vec3 q0 = m.X_PW0 * x_W, q1 = m.X_PW1 * x_W;
  const double slack = single_slack(m.region_W.box);
  if (g.radius > 0.0) return misses_cylinder(g, q0, q1, slack);
  for (int k = 0; k < 3; ++k)
    if (std::min(q0[k], q1[k]) > g.box_P.hi[k] || std::max(q0[k], q1[k]) < g.box_P.lo[k])
      return true;
  return separating_plane(g.hull_P, q0, q1, slack) < g.hull_P.b.size();
}

bool is_far_from(const CuttingGroup& g, const Vec3& x_P, double gap) {
  if (g.radius > 0.0)
    return x_P.x() >= g.box_P.hi.x() + gap || x_P.x() <= g.box_P.lo.x() - gap ||
           x_P.tail<2>().norm() >= g.radius + gap;
  return separating_plane(g.hull_P, x_P, x_P, gap) < g.hull_P.b.size();
}

}  // namespace tdbd::rock
