#include "rock/section/crossing_segments.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace tdbd::rock {
namespace {

/// A vertex and its distance ahead of the plane.
struct Seen {
  int v;
  const mesh::VertexStar* star;
  double ahead;
};

/// Where an edge crosses the plane.
struct Crossing {
  Vec2 x_F;
  const FaceColumn* column;  ///< that holds it, or one nearby
  bool is_in_zone;           ///< the outline is followed here
  bool is_in_face;           ///< inside the columns
  bool is_beneath;           ///< not above the line of the column's lower edge
};

double above_lower_edge(const Vec2& x_F, const FaceColumn& c) {
  return x_F.y() - (c.lower + c.lower_slope * (x_F.x() - c.y0));
}

/// The face is convex: with two points it holds all between them, and no line of a lower edge
/// enters it.
SegmentPlace place_of(const Crossing& from, const Crossing& to) {
  if (from.is_in_face && to.is_in_face) return SegmentPlace::inside;
  const bool is_beneath = (from.is_beneath && above_lower_edge(to.x_F, *from.column) <= 0.0) ||
                          (to.is_beneath && above_lower_edge(from.x_F, *to.column) <= 0.0);
  return is_beneath ? SegmentPlace::beneath : SegmentPlace::anywhere;
}

/// Finds the outline of one plane, by the stars of the vertices ahead of it.
class OutlineSearch {
 public:
  OutlineSearch(const Rock& rock, const FacePlane& plane, OutlineWork& work)
      : s_(rock.surface), f_(plane), w_(work) {}

  bool is_start(int v) const { return is_start(seen(v)); }
  void around(int v);

 private:
  /// Where the outline crosses an edge: its ends, and the number of the vertex behind in the ring of
  /// the vertex ahead.
  struct Front {
    Seen ahead, behind;
    int i;
    Crossing at;
  };

  Seen seen(int v) const {
    const mesh::VertexStar& star = s_.star(v);
    return {v, &star, f_.ahead(star.x)};
  }
  bool is_start(const Seen& a) const;
  const FaceColumn& near(const Vec2& x_F) const {
    return f_.face.columns[f_.face.near(std::clamp(x_F.x(), f_.left, f_.right))];
  }
  bool is_in_zone(const Vec2& x_F, const FaceColumn& near) const;
  Crossing crossing(const Seen& ahead, const Seen& behind) const;
  void passage(const Seen& v, int i);
  void follow(Front f);
  void follow_back(Front f);
  void step_to(int w, int i, Front& f) const;
  void add(const Crossing& from, const Crossing& to) {
    w_.segments.push_back({from.x_F, to.x_F, place_of(from, to)});
  }

  const mesh::Surface& s_;
  const FacePlane& f_;
  OutlineWork& w_;
};

bool OutlineSearch::is_in_zone(const Vec2& x_F, const FaceColumn& near) const {
  if (x_F.x() < f_.left - f_.reach || x_F.x() > f_.right + f_.reach) return false;
  if (x_F.y() > f_.face.hi_F.y() + f_.reach) return false;
  return -above_lower_edge(x_F, near) <= f_.reach * near.lower_rise;
}

bool OutlineSearch::is_start(const Seen& a) const {
  if (!(a.ahead >= 0.0 && a.ahead <= f_.reach)) return false;
  const Vec2 x_F = f_.in_plane(a.star->x);
  if (x_F.y() > f_.top || x_F.y() < f_.face.lo_F.y() - f_.reach) return false;
  return is_in_zone(x_F, near(x_F));
}

/// A function of the edge: its two triangles are given the same point.
Crossing OutlineSearch::crossing(const Seen& ahead, const Seen& behind) const {
  const Vec3 &a_W = ahead.star->x, &b_W = behind.star->x;
  const double w = ahead.ahead / (ahead.ahead - behind.ahead);
  const Vec2 x_F =
      f_.in_plane({a_W.x() + w * (b_W.x() - a_W.x()), a_W.y() + w * (b_W.y() - a_W.y()),
                   a_W.z() + w * (b_W.z() - a_W.z())});
  const FaceColumn& first = near(x_F);
  const bool is_between = x_F.x() > f_.left && x_F.x() < f_.right;
  const FaceColumn& c = is_between && x_F.x() > first.y1 ? *(&first + 1) : first;
  const double above = above_lower_edge(x_F, c), dy = x_F.x() - c.y0;
  const bool is_in_face =
      is_between && above > 0.0 && x_F.x() <= c.y1 && x_F.y() < c.upper + c.upper_slope * dy;
  return {x_F, &c, is_in_zone(x_F, first), is_in_face, above <= 0.0};
}

/// Every passage of the outline around this vertex, from the first of its neighbours behind on;
/// where all are behind, from any. Bit by bit, since branches on positions are unpredictable.
void OutlineSearch::around(int v) {
  const Seen centre = seen(v);
  const mesh::VertexStar& star = *centre.star;
  const int* ring = s_.ring(star);
  const int last = star.size - 1;
  const bool is_open = star.open != 0;
  bool before = !is_open && seen(ring[last]).ahead < 0.0, is_all = before;
  for (int first = 0; first <= last; first += 64) {
    std::uint64_t behind = 0;
    const int count = std::min(64, star.size - first);
    for (int i = 0; i < count; ++i)
      behind |= std::uint64_t{f_.ahead(s_.position(ring[first + i])) < 0.0} << i;
    is_all = is_all && behind == ~std::uint64_t{0} >> (64 - count);
    for (std::uint64_t begins = behind & ~(behind << 1U | std::uint64_t{before}); begins != 0;
         begins &= begins - 1U)
      passage(centre, first + std::countr_zero(begins));
    before = (behind >> 63U) != 0;
  }
  if (is_all) passage(centre, 0);
}

/// The outline on either side of the edge from v to its neighbour number i, behind.
void OutlineSearch::passage(const Seen& v, int i) {
  if (v.star->open != 0 && i + 1 == v.star->size) return;
  if (w_.crossed.contains(v.v, i)) return;
  const Seen behind = seen(s_.ring(*v.star)[i]);
  const Front front{v, behind, i, crossing(v, behind)};
  follow(front);
  follow_back(front);
}

/// Goes to the next edge of the triangle with the vertex w, number i in the ring of the vertex
/// ahead.
void OutlineSearch::step_to(int w, int i, Front& f) const {
  const Seen next = seen(w);
  if (next.ahead < 0.0) {
    f.behind = next;
    f.i = i;
  } else {
    f.ahead = next;
    const int* ring = s_.ring(*next.star);
    f.i = 0;
    while (ring[f.i] != f.behind.v) ++f.i;
  }
  f.at = crossing(f.ahead, f.behind);
}

/// Follows the outline until it leaves the zone, but all around the vertices to start from.
void OutlineSearch::follow(Front f) {
  bool goes_on = true;
  while (goes_on) {
    const bool is_last = f.i + 1 == f.ahead.star->size;
    if ((is_last && f.ahead.star->open != 0) || !w_.crossed.add(f.ahead.v, f.i)) return;
    const Crossing from = f.at;
    const int i = is_last ? 0 : f.i + 1;
    step_to(s_.ring(*f.ahead.star)[i], i, f);
    add(from, f.at);
    goes_on = f.at.is_in_zone || is_start(f.ahead);
  }
}

/// Follows the outline back until it leaves the zone.
void OutlineSearch::follow_back(Front f) {
  while (f.at.is_in_zone) {
    if (f.i == 0 && f.ahead.star->open != 0) return;
    const Crossing to = f.at;
    const int i = f.i == 0 ? f.ahead.star->size - 1 : f.i - 1;
    step_to(s_.ring(*f.ahead.star)[i], i, f);
    if (!w_.crossed.add(f.ahead.v, f.i)) return;
    add(f.at, to);
  }
}

/// Prefetches these vertices.
void prefetch(const mesh::Surface& s, const std::vector<int>& near) {
  for (const int v : near) __builtin_prefetch(&s.star(v));
}

/// Where vertices to start from may be.
Region region_of(const FacePlane& f) {
  const double rounding = 1e-9 * f.reach, reach = f.reach + rounding;
  Region region{};
  region.slabs[0] = {f.n_W, f.n0 - rounding, f.n0 + reach};
  region.slabs[1] = {f.y_W, f.y0 + f.left - reach, f.y0 + f.right + reach};
  region.slabs[2] = {f.z_W, f.z0 + f.face.lo_F.y() - reach, f.z0 + f.top + rounding};
  region.box = box_around(region.slabs);
  return region;
}

/// Vertices ahead of the plane by at most its reach, and those that single precision cannot
/// distinguish from them.
void find_near(const Rock& rock, const FacePlane& plane, OutlineWork& work) {
  const Region region = region_of(plane);
  const double slack = single_slack(region.box);
  work.near.clear();
  const auto list = static_cast<std::size_t>(plane.near_list);
  if (plane.near_list >= 0 && list < rock.near_lists.size() &&
      covers(rock.near_lists[list], rock.grid, region))
    return add_vertices_between(rock.near_lists[list], region, slack, work.near);
  const double from = plane.n0 - slack, to = plane.n0 + plane.reach + slack;
  rock.grid.visit(region, work.chains, [&](const VertexGrid::Block& block) {
    std::size_t found = work.near.size();
    work.near.resize(found + VertexGrid::block_size);
    for (std::size_t e = 0; e < static_cast<std::size_t>(block.count); ++e) {
      const double along = plane.n_W.dot(Vec3(block.x[e], block.y[e], block.z[e]));
      work.near[found] = block.v[e];  // branch-free: the outcome is unpredictable
      found +=
          static_cast<std::size_t>(static_cast<int>(along >= from) & static_cast<int>(along <= to));
    }
    work.near.resize(found);
  });
}

}  // namespace

FacePlane face_plane(const Pose& X_WF, const FaceColumns& face, std::size_t first, std::size_t end,
                     double reach, double top, int near_list) {
  const Vec3 n_W = X_WF.R.col(0), y_W = X_WF.R.col(1), z_W = X_WF.R.col(2);
  return {n_W,
          y_W,
          z_W,
          n_W.dot(X_WF.p),
          y_W.dot(X_WF.p),
          z_W.dot(X_WF.p),
          face,
          face.columns[first].y0,
          face.columns[end - 1].y1,
          reach,
          top,
          near_list};
}

void find_outline(const Rock& rock, const FacePlane& plane, OutlineWork& work) {
  work.segments.clear();
  work.crossed.clear();
  find_near(rock, plane, work);
  OutlineSearch search(rock, plane, work);
  prefetch(rock.surface, work.near);
  std::erase_if(work.near, [&](int v) { return !search.is_start(v); });
  for (const int v : work.near) search.around(v);
}

}  // namespace tdbd::rock
