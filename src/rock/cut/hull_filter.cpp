#include "rock/cut/hull_filter.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "mesh/surface.hpp"
#include "rock/cut/plane_strip.hpp"
#include "rock/cut/sieves.hpp"

namespace tdbd::rock {
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
