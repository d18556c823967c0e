#include "rock/section/crossing_segments.hpp"

#include <algorithm>

namespace tdbd::rock {
namespace {

/// A vertex and its distance ahead of the plane.
struct Seen {
  int v;
  double ahead;
};

/// Where an edge crosses the plane.
struct Crossing {
  Vec2 x_F;
  bool is_in_zone;  ///< the outline is followed here
  bool is_in_face;  ///< inside the columns
};

/// Finds the outline of one plane, by the stars of the vertices ahead of it.
class OutlineSearch {
 public:
  OutlineSearch(const Rock& rock, const FacePlane& plane, OutlineWork& work)
      : s_(rock.surface), f_(plane), w_(work) {}

  bool is_start(int v) const { return is_start({v, ahead(v)}); }
  void around(int v);

 private:
  /// Where the outline crosses an edge: its ends, and the number of the vertex behind in the ring of
  /// the vertex ahead.
  struct Front {
    Seen ahead, behind;
    const mesh::VertexStar* star;  ///< of the vertex ahead
    int i;
    Crossing at;
  };

  double ahead(int v) const { return f_.ahead(s_.position(v)); }
  bool is_start(const Seen& a) const;
  bool is_in_zone(const Vec2& x_F, const FaceColumn& near) const;
  Crossing crossing(const Seen& ahead, const Seen& behind) const;
  void passage(const Seen& v, const mesh::VertexStar& star, int i);
  void follow(Front f);
  void follow_back(Front f);
  void step_to(int w, int i, Front& f) const;
  void add(const Crossing& from, const Crossing& to) {
    w_.segments.push_back({from.x_F, to.x_F, from.is_in_face && to.is_in_face});
  }

  const mesh::Surface& s_;
  const FacePlane& f_;
  OutlineWork& w_;
};

bool OutlineSearch::is_in_zone(const Vec2& x_F, const FaceColumn& near) const {
  if (x_F.x() < f_.left - f_.reach || x_F.x() > f_.right + f_.reach) return false;
  if (x_F.y() > f_.face.hi_F.y() + f_.reach) return false;
  const double below = near.lower + near.lower_slope * (x_F.x() - near.y0) - x_F.y();
  return below <= f_.reach * near.lower_rise;
}

bool OutlineSearch::is_start(const Seen& a) const {
  if (!(a.ahead >= 0.0 && a.ahead <= f_.reach)) return false;
  const Vec2 x_F = f_.in_plane(s_.position(a.v));
  if (x_F.y() > f_.top || x_F.y() < f_.face.lo_F.y() - f_.reach) return false;
  const double y = std::clamp(x_F.x(), f_.left, f_.right);
  return is_in_zone(x_F, f_.face.columns[f_.face.near(y)]);
}

bool is_in_column(const Vec2& x_F, const FaceColumn& c) {
  const double dy = x_F.x() - c.y0;
  return dy >= 0.0 && x_F.x() <= c.y1 && x_F.y() > c.lower + c.lower_slope * dy &&
         x_F.y() < c.upper + c.upper_slope * dy;
}

/// A function of the edge: its two triangles are given the same point.
Crossing OutlineSearch::crossing(const Seen& ahead, const Seen& behind) const {
  const Vec3 &a_W = s_.position(ahead.v), &b_W = s_.position(behind.v);
  const double w = ahead.ahead / (ahead.ahead - behind.ahead);
  const Vec2 x_F = f_.in_plane(a_W + w * (b_W - a_W));
  const double y = std::clamp(x_F.x(), f_.left, f_.right);
  const FaceColumn& near = f_.face.columns[f_.face.near(y)];
  const bool is_between = x_F.x() > f_.left && x_F.x() < f_.right;
  return {x_F, is_in_zone(x_F, near),
          is_between && is_in_column(x_F, *(y > near.y1 ? &near + 1 : &near))};
}

/// Every passage of the outline around this vertex, from the first of its neighbours behind on.
void OutlineSearch::around(int v) {
  const mesh::VertexStar& star = s_.star(v);
  const int* ring = s_.ring(star);
  const Seen seen{v, ahead(v)};
  const bool first = ahead(ring[0]) < 0.0;
  bool before = first, all = first;
  for (int i = 1; i < star.size; ++i) {
    const bool now = ahead(ring[i]) < 0.0;
    if (now && !before) passage(seen, star, i);
    before = now;
    all = all && now;
  }
  if (first && (star.open != 0 || !before || all)) passage(seen, star, 0);
}

/// The outline on either side of the edge from v to its neighbour number i, behind.
void OutlineSearch::passage(const Seen& v, const mesh::VertexStar& star, int i) {
  if (star.open != 0 && i + 1 == star.size) return;
  if (w_.crossed.contains(v.v, i)) return;
  const int b = s_.ring(star)[i];
  const Seen behind{b, ahead(b)};
  const Front front{v, behind, &star, i, crossing(v, behind)};
  follow(front);
  follow_back(front);
}

/// Goes to the next edge of the triangle with the vertex w, number i in the ring of the vertex
/// ahead.
void OutlineSearch::step_to(int w, int i, Front& f) const {
  const Seen seen{w, ahead(w)};
  if (seen.ahead < 0.0) {
    f.behind = seen;
    f.i = i;
  } else {
    f.ahead = seen;
    f.star = &s_.star(w);
    const int* ring = s_.ring(*f.star);
    f.i = 0;
    while (ring[f.i] != f.behind.v) ++f.i;
  }
  f.at = crossing(f.ahead, f.behind);
}

/// Follows the outline until it leaves the zone, but all around the vertices to start from.
void OutlineSearch::follow(Front f) {
  bool goes_on = true;
  while (goes_on) {
    const bool is_last = f.i + 1 == f.star->size;
    if ((is_last && f.star->open != 0) || !w_.crossed.add(f.ahead.v, f.i)) return;
    const Crossing from = f.at;
    const int i = is_last ? 0 : f.i + 1;
    step_to(s_.ring(*f.star)[i], i, f);
    add(from, f.at);
    goes_on = f.at.is_in_zone || is_start(f.ahead);
  }
}

/// Follows the outline back until it leaves the zone.
void OutlineSearch::follow_back(Front f) {
  while (f.at.is_in_zone) {
    if (f.i == 0 && f.star->open != 0) return;
    const Crossing to = f.at;
    const int i = f.i == 0 ? f.star->size - 1 : f.i - 1;
    step_to(s_.ring(*f.star)[i], i, f);
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
