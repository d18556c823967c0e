#include "rock/section/crossing_segments.hpp"

#include <algorithm>

namespace tdbd::rock {
namespace {

/// A vertex and its distance ahead of the plane.
struct Seen {
  int v;
  Vec3 x_W;
  double ahead;
};

/// Finds the outline of one plane.
class OutlineSearch {
 public:
  OutlineSearch(const Rock& rock, const FacePlane& plane, OutlineWork& work)
      : rock_(rock), s_(rock.surface), f_(plane), w_(work) {}

  void around(int v);
  bool is_in_zone(const Vec2& x_F) const;
  bool is_start(const Seen& a) const {
    if (!(a.ahead >= 0.0 && a.ahead <= f_.reach)) return false;
    const Vec2 x_F = f_.in_plane(a.x_W);
    return x_F.y() <= f_.top && is_in_zone(x_F);
  }
  Seen seen(int v) const {
    const Vec3& x_W = s_.position(v);
    return {v, x_W, f_.ahead(x_W)};
  }

 private:
  Seen seen_at(int corner) const { return seen(s_.vertex(corner)); }
  /// An edge gives its two triangles the same point.
  Vec2 crossing(const Seen& ahead, const Seen& behind) const {
    const double w = ahead.ahead / (ahead.ahead - behind.ahead);
    return f_.in_plane(ahead.x_W + w * (behind.x_W - ahead.x_W));
  }
  void triangle(int c, const Seen& v, const Seen& next, const Seen& last, bool ask_before);
  void follow(int facing, int ahead, int behind, Vec2 from);
  void follow_back(int facing, int ahead, int behind, Vec2 to);

  const Rock& rock_;
  const mesh::Surface& s_;
  const FacePlane& f_;
  OutlineWork& w_;
};

bool OutlineSearch::is_in_zone(const Vec2& x_F) const {
  const FaceColumns& face = f_.face;
  if (x_F.x() < f_.left - f_.reach || x_F.x() > f_.right + f_.reach) return false;
  if (x_F.y() > face.hi_F.y() + f_.reach) return false;
  const double y = std::clamp(x_F.x(), f_.left, f_.right);
  const FaceColumn& c = face.columns[face.near(y)];
  const double below = c.lower + c.lower_slope * (x_F.x() - c.y0) - x_F.y();
  return below <= f_.reach * c.lower_rise;
}

/// The corner of a vertex from which turning left reaches all others.
int first_corner(const mesh::Surface& s, int v) {
  const int start = s.corner_of[at(v)];
  if (!s.is_boundary(v)) return start;
  int c = start;
  for (int right = mesh::turn_right(s, c); right >= 0; right = mesh::turn_right(s, c)) c = right;
  return c;
}

/// The triangles that cross the plane on an edge from this vertex to one behind.
void OutlineSearch::around(int v) {
  const Seen centre = seen(v);
  const int first = first_corner(s_, v);
  Seen next = seen_at(mesh::next_corner(first));
  bool ask_before = true;
  int c = first;
  do {
    const Seen last = seen_at(mesh::previous_corner(c));
    if (next.ahead < 0.0) triangle(c, centre, next, last, ask_before);
    ask_before = next.ahead >= 0.0;
    next = last;
    c = mesh::turn_left(s_, c);
  } while (c >= 0 && c != first);
}

/// The triangle with this corner at v. Follows the outline on either side where the vertex ahead is
/// none to start from; the side before may be known to be around v, too.
void OutlineSearch::triangle(int c, const Seen& v, const Seen& next, const Seen& last,
                             bool ask_before) {
  const Vec2 from = crossing(v, next);
  const Vec2 to = last.ahead >= 0.0 ? crossing(last, next) : crossing(v, last);
  w_.segments.push_back({from, to});
  if (last.ahead >= 0.0 && !is_start(last)) follow(c, last.v, next.v, to);
  const int before = ask_before ? s_.opposite_of(mesh::previous_corner(c)) : -1;
  if (before < 0) return;
  const Seen u = seen_at(before);
  if (u.ahead >= 0.0 && !is_start(u)) follow_back(mesh::previous_corner(c), v.v, next.v, from);
}

/// Follows the outline over the edge that this corner faces, until it leaves the zone or reaches a
/// vertex to start from.
void OutlineSearch::follow(int facing, int ahead, int behind, Vec2 from) {
  while (is_in_zone(from)) {
    const int o = s_.opposite_of(facing);
    if (o < 0) return;
    const Seen a = seen(ahead), b = seen(behind), w = seen_at(o);
    const bool turns = w.ahead >= 0.0;
    const Vec2 to = turns ? crossing(w, b) : crossing(a, w);
    w_.segments.push_back({from, to});
    if (turns && is_start(w)) return;
    (turns ? ahead : behind) = w.v;
    facing = turns ? mesh::next_corner(o) : mesh::previous_corner(o);
    from = to;
  }
}

/// Follows the outline back over the edge that this corner faces. What leads back to a vertex to
/// start from is found from there; otherwise it is kept.
void OutlineSearch::follow_back(int facing, int ahead, int behind, Vec2 to) {
  w_.run.clear();
  while (is_in_zone(to)) {
    const int o = s_.opposite_of(facing);
    if (o < 0) break;
    const Seen a = seen(ahead), b = seen(behind), w = seen_at(o);
    const bool turns = w.ahead >= 0.0;
    if (turns && is_start(w)) return;
    const Vec2 from = turns ? crossing(w, b) : crossing(a, w);
    w_.run.push_back({from, to});
    (turns ? ahead : behind) = w.v;
    facing = turns ? mesh::previous_corner(o) : mesh::next_corner(o);
    to = from;
  }
  w_.segments.insert(w_.segments.end(), w_.run.begin(), w_.run.end());
}

/// Prefetches the first triangles of all these vertices.
void prefetch(const mesh::Surface& s, const std::vector<int>& near) {
  for (const int v : near) __builtin_prefetch(&s.corner_of[at(v)]);
  for (const int v : near) {
    const auto c = static_cast<std::size_t>(s.corner_of[at(v)]);
    __builtin_prefetch(&s.triangles[c / 3]);
    __builtin_prefetch(&s.opposite[c]);
  }
  for (const int v : near) {
    const int c = s.corner_of[at(v)];
    for (const int o :
         {s.opposite_of(mesh::next_corner(c)), s.opposite_of(mesh::previous_corner(c))}) {
      if (o < 0) continue;
      __builtin_prefetch(&s.triangles[at(o / 3)]);
      __builtin_prefetch(&s.opposite[at(o)]);
    }
  }
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
  find_near(rock, plane, work);
  OutlineSearch search(rock, plane, work);
  std::erase_if(work.near, [&](int v) { return !search.is_start(search.seen(v)); });
  prefetch(rock.surface, work.near);
  for (const int v : work.near) search.around(v);
}

}  // namespace tdbd::rock
