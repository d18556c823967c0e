#include "rock/section/crossing_segments.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace tdbd::rock {

void CrossedEdges::clear() {
  ++generation_;
  count_ = 0;
}

std::uint64_t& CrossedEdges::insert(std::uint64_t key, std::size_t place) {
  if (2 * count_ >= entries_.size()) {
    grow();
    place = place_of(key);
  }
  ++count_;
  entries_[place] = {key, 0, generation_, false};
  return entries_[place].edges;
}

void CrossedEdges::grow() {
  const std::vector<Entry> old = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
  --shift_;
  for (const Entry& e : old)
    if (e.generation == generation_) entries_[place_of(e.key)] = e;
}

namespace {

double above_lower_edge(const Vec2& x_F, const FaceColumn& c) {
  return x_F.y() - (c.lower + c.lower_slope * (x_F.x() - c.y0));
}

/// Finds the outline in one plane, by the stars of the vertices ahead of the plane.
class OutlineSearch {
 public:
  OutlineSearch(const Rock& rock, const FacePlane& plane, OutlineWork& work)
      : s_(rock.surface), f_(plane), inner_(plane.face.inner), w_(work) {
    inner_.left = std::max(inner_.left, plane.left);
    inner_.right = std::min(inner_.right, plane.right);
  }

  bool is_start(int v) const { return is_start(s_.star(v)); }
  void around(int v);

 private:
  /// An edge that crosses the plane: its ends, their distances ahead of it, and the index of the
  /// end behind in the ring of the end ahead.
  struct Edge {
    const mesh::VertexStar *ahead, *behind;
    double distance_ahead, distance_behind;  ///< m; that of the end behind is negative
    int v_ahead, v_behind, i;
  };
  enum class Way { on, back };  ///< counter-clockwise around vertices ahead, or clockwise

  double ahead(const mesh::VertexStar& star) const { return f_.ahead(star.x); }
  bool is_start(const mesh::VertexStar& star) const;
  const FaceColumn& near(double y) const {
    return f_.face.columns[f_.face.near(std::clamp(y, f_.left, f_.right))];
  }
  bool is_in_zone(const Vec2& x_F, const FaceColumn& near) const;
  bool append(const Edge& e);
  bool append_off_centre(const Vec2& x_F);
  void passage(int v, const mesh::VertexStar& star, double distance, int i);
  bool are_rest_ahead(const mesh::VertexStar& star, int first, int last) const;
  template <Way way>
  bool step(Edge& e) const;
  void leave(int v, const mesh::VertexStar& star, int first, int last);
  void follow(Edge e, bool is_in_zone);
  void follow_back(Edge e, bool is_in_zone);

  const mesh::Surface& s_;
  const FacePlane& f_;
  InnerCircle inner_;  ///< restricted to the interval between the ends of the columns
  OutlineWork& w_;
};

bool OutlineSearch::is_in_zone(const Vec2& x_F, const FaceColumn& near) const {
  if (x_F.x() < f_.left - f_.reach || x_F.x() > f_.right + f_.reach) return false;
  if (x_F.y() > f_.face.hi_F.y() + f_.reach) return false;
  return -above_lower_edge(x_F, near) <= f_.reach * near.lower_rise;
}

bool OutlineSearch::is_start(const mesh::VertexStar& star) const {
  const double distance = ahead(star);
  if (!(distance >= 0.0 && distance <= f_.reach)) return false;
  const Vec2 x_F = f_.in_plane(star.x);
  if (x_F.y() > f_.top || x_F.y() < f_.face.lo_F.y() - f_.reach) return false;
  return is_in_zone(x_F, near(x_F.x()));
}

/// Appends the point at which the edge crosses the plane. It is a function of the edge alone, so
/// both triangles of the edge get the same point. Returns whether it is in the zone.
inline bool OutlineSearch::append(const Edge& e) {
  const Vec3 &a_W = e.ahead->x, &b_W = e.behind->x;
  const double w = e.distance_ahead / (e.distance_ahead - e.distance_behind);
  const Vec2 x_F =
      f_.in_plane({a_W.x() + w * (b_W.x() - a_W.x()), a_W.y() + w * (b_W.y() - a_W.y()),
                   a_W.z() + w * (b_W.z() - a_W.z())});
  w_.y.push_back(x_F.x());
  w_.z.push_back(x_F.y());
  if (!contains(inner_, x_F)) return append_off_centre(x_F);
  w_.place.push_back({PointPlace::inside, nullptr});
  return true;
}

bool OutlineSearch::append_off_centre(const Vec2& x_F) {
  const FaceColumn& first = near(x_F.x());
  const bool is_between = x_F.x() > f_.left && x_F.x() < f_.right;
  const FaceColumn& c = is_between && x_F.x() > first.y1 ? *(&first + 1) : first;
  const double above = above_lower_edge(x_F, c), dy = x_F.x() - c.y0;
  const bool is_inside =
      is_between && above > 0.0 && x_F.x() <= c.y1 && x_F.y() < c.upper + c.upper_slope * dy;
  w_.place.push_back({is_inside      ? PointPlace::inside
                      : above <= 0.0 ? PointPlace::beneath
                                     : PointPlace::anywhere,
                      &c});
  return is_in_zone(x_F, first);
}

/// Finds every passage of the outline around this vertex, starting at the first neighbour behind
/// the plane (at any neighbour if all are behind). Uses bit masks because branches on positions are
/// unpredictable.
void OutlineSearch::around(int v) {
  const mesh::VertexStar& star = s_.star(v);
  const double distance = ahead(star);
  const int* ring = s_.ring(star);
  const int last = static_cast<int>(star.size) - 1;
  const bool is_open = star.open != 0;
  bool before = !is_open && ahead(s_.star(ring[last])) < 0.0, is_all = before;
  for (int first = 0; first <= last; first += 64) {
    std::uint64_t behind = 0;
    const int count = std::min(64, last + 1 - first);
    for (int i = 0; i < count; ++i)
      behind |= std::uint64_t{ahead(s_.star(ring[first + i])) < 0.0} << i;
    is_all = is_all && behind == ~std::uint64_t{0} >> (64 - count);
    for (std::uint64_t begins = behind & ~(behind << 1U | std::uint64_t{before}); begins != 0;
         begins &= begins - 1U)
      passage(v, star, distance, first + std::countr_zero(begins));
    before = (behind >> 63U) != 0;
  }
  if (is_all) passage(v, star, distance, 0);
}

/// Finds the outline on both sides of the edge from v to its neighbour with index i, which is
/// behind the plane, as one run of points: first backwards, which is then reversed, then forwards.
void OutlineSearch::passage(int v, const mesh::VertexStar& star, double distance, int i) {
  if (star.open != 0 && i + 1 == static_cast<int>(star.size)) return;
  if (w_.crossed.contains(v, i)) return;
  const int v_behind = s_.ring(star)[i];
  const mesh::VertexStar& behind = s_.star(v_behind);
  const Edge edge{&star, &behind, distance, ahead(behind), v, v_behind, i};
  const auto first = static_cast<std::ptrdiff_t>(w_.y.size());
  const bool is_in_zone = append(edge);
  follow_back(edge, is_in_zone);
  std::reverse(w_.y.begin() + first, w_.y.end());
  std::reverse(w_.z.begin() + first, w_.z.end());
  std::reverse(w_.place.begin() + first, w_.place.end());
  follow(edge, is_in_zone);
  const auto begin = static_cast<std::size_t>(first);
  if (w_.y.size() > begin + 1) return w_.runs.push_back({begin, w_.y.size()});
  w_.y.resize(begin);
  w_.z.resize(begin);
  w_.place.resize(begin);
}

/// Moves to the next edge that the outline crosses, in the triangle on this side of the edge.
/// Returns false at the rock's boundary.
template <OutlineSearch::Way way>
inline bool OutlineSearch::step(Edge& e) const {
  const int last = static_cast<int>(e.ahead->size) - 1;
  const bool is_end = e.i == (way == Way::on ? last : 0);
  if (is_end && e.ahead->open != 0) return false;
  const int i = way == Way::on ? (is_end ? 0 : e.i + 1) : (is_end ? last : e.i - 1);
  const int v = s_.ring(*e.ahead)[i];
  const mesh::VertexStar& star = s_.star(v);
  const double distance = ahead(star);
  if (distance < 0.0) {
    e.behind = &star;
    e.distance_behind = distance;
    e.v_behind = v;
    e.i = i;
  } else {
    e.ahead = &star;
    e.distance_ahead = distance;
    e.v_ahead = v;
    const int* ring = s_.ring(star);
    e.i = 0;
    while (ring[e.i] != e.v_behind) ++e.i;
  }
  return true;
}

/// Whether all neighbours of a closed star are ahead, except those with indices `first` to `last`,
/// counter-clockwise. The neighbour on either side of these is known to be ahead.
bool OutlineSearch::are_rest_ahead(const mesh::VertexStar& star, int first, int last) const {
  const int size = static_cast<int>(star.size);
  const int* ring = s_.ring(star);
  const int behind = last - first + (last < first ? size : 0) + 1;
  int i = last + 2;
  for (int rest = size - behind - 2; rest > 0; --rest, ++i)
    if (ahead(s_.star(ring[i < size ? i : i - size])) < 0.0) return false;
  return true;
}

/// Marks a vertex as done if the outline passes it only once, with neighbours `first` to `last`
/// behind.
void OutlineSearch::leave(int v, const mesh::VertexStar& star, int first, int last) {
  if (star.open == 0 && star.long_ring < 0 && are_rest_ahead(star, first, last))
    w_.crossed.mark_done(v);
}

/// Follows the outline until it leaves the zone, but completely around start vertices.
void OutlineSearch::follow(Edge e, bool is_in_zone) {
  int first = e.i;  // index of the first neighbour behind
  for (bool goes_on = true; goes_on; goes_on = is_in_zone || is_start(*e.ahead)) {
    const mesh::VertexStar* const star = e.ahead;
    const int v = e.v_ahead, i = e.i;
    if (!step<Way::on>(e) || !w_.crossed.add(v, i)) return;
    is_in_zone = append(e);
    if (e.v_ahead == v) continue;
    leave(v, *star, first, i);
    first = e.i;
  }
}

/// Follows the outline backwards until it leaves the zone.
void OutlineSearch::follow_back(Edge e, bool is_in_zone) {
  constexpr int unknown = -1;
  int last = unknown;  // index of the last neighbour behind; not known for the first vertex
  while (is_in_zone) {
    const mesh::VertexStar* const star = e.ahead;
    const int v = e.v_ahead, i = e.i;
    if (!step<Way::back>(e) || !w_.crossed.add(e.v_ahead, e.i)) return;
    is_in_zone = append(e);
    if (e.v_ahead == v) continue;
    if (last != unknown) leave(v, *star, i, last);
    last = e.i;
  }
}

/// Prefetches these vertices.
void prefetch(const mesh::Surface& s, const std::vector<int>& near) {
  for (const int v : near) __builtin_prefetch(&s.star(v));
}

/// The region that contains all start vertices.
Region region_of(const FacePlane& f) {
  const double rounding = 1e-9 * f.reach, reach = f.reach + rounding;
  Region region{};
  region.slabs[0] = {f.n_W, f.n0 - rounding, f.n0 + reach};
  region.slabs[1] = {f.y_W, f.y0 + f.left - reach, f.y0 + f.right + reach};
  region.slabs[2] = {f.z_W, f.z0 + f.face.lo_F.y() - reach, f.z0 + f.top + rounding};
  region.box = box_around(region.slabs);
  return region;
}

/// Finds the vertices ahead of the plane by at most its reach, and those that single precision
/// cannot distinguish from them.
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
      work.near[found] = block.v[e];  // branch-free because the outcome is unpredictable
      found +=
          static_cast<std::size_t>(static_cast<int>(along >= from) & static_cast<int>(along <= to));
    }
    work.near.resize(found);
  });
}

/// The face is convex: it contains all points between two of its points, and no line of a lower
/// edge enters it.
bool is_beneath(const OutlineWork& w, std::size_t from, std::size_t to) {
  return w.place[from].place == PointPlace::beneath &&
         above_lower_edge({w.y[to], w.z[to]}, *w.place[from].column) <= 0.0;
}

}  // namespace

bool is_beneath(const OutlineWork& w, std::size_t k) {
  return is_beneath(w, k, k + 1) || is_beneath(w, k + 1, k);
}

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
  work.y.clear();
  work.z.clear();
  work.place.clear();
  work.runs.clear();
  work.crossed.clear();
  find_near(rock, plane, work);
  OutlineSearch search(rock, plane, work);
  prefetch(rock.surface, work.near);
  for (const int v : work.near)
    if (!work.crossed.is_done(v) && search.is_start(v)) search.around(v);
}

}  // namespace tdbd::rock
