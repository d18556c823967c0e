#include "rock/index/near_list.hpp"

#include <bit>
#include <cmath>

#include "rotation/screw.hpp"

namespace tdbd::rock {
namespace {

/// Half the extent along n of a box with these axes.
double spread(const Vec3& n, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& half) {
  return std::abs(n.dot(a)) * half.x() + std::abs(n.dot(b)) * half.y() +
         std::abs(n.dot(c)) * half.z();
}

/// Half the extent along n of the box between orthogonal slabs.
double spread(const Vec3& n, const std::array<Slab, 3>& slabs, const Vec3& half) {
  return spread(n, slabs[0].n, slabs[1].n, slabs[2].n, half);
}

void add(Slab& s, double middle, double half) {
  s.lo = std::min(s.lo, middle - half);
  s.hi = std::max(s.hi, middle + half);
}

void add_box(const mesh::Box& box_P, const Pose& X_WP, std::array<Slab, 3>& slabs) {
  const Vec3 centre_W = X_WP * Vec3(0.5 * (box_P.lo + box_P.hi)), half = 0.5 * box_P.size();
  for (Slab& s : slabs)
    add(s, s.n.dot(centre_W), spread(s.n, X_WP.R.col(0), X_WP.R.col(1), X_WP.R.col(2), half));
}

void add_region(const Region& region_W, std::array<Slab, 3>& slabs) {
  const SlabBox m = slab_box(region_W.slabs);
  for (Slab& s : slabs) add(s, s.n.dot(m.centre_W), spread(s.n, region_W.slabs, m.half));
}

}  // namespace

double travel_in_step(const GroupStep& step) {
  const Vec3 middle_P = 0.5 * (step.box_P.lo + step.box_P.hi);
  return (step.X_WP1 * middle_P - step.X_WP0 * middle_P).norm();
}

bool holds(const Region& region_W, const Region& part_W) {
  const SlabBox m = slab_box(part_W.slabs);
  return std::ranges::all_of(region_W.slabs, [&](const Slab& s) {
    const double at = s.n.dot(m.centre_W), half = spread(s.n, part_W.slabs, m.half);
    return at - half >= s.lo && at + half <= s.hi;
  });
}

Region region_ahead(const GroupStep& step, const NearListMargins& margins, int steps) {
  constexpr double largest_turn = 0.75, sideways = 1e-2;  // rad; times the size of the box
  const rotation::Twist twist = rotation::twist_from(step.X_WP0, step.X_WP1, 1.0);
  const double speed = rotation::velocity_B(twist, 0.5 * (step.box_P.lo + step.box_P.hi)).norm(),
               turn = twist.angular_B.norm();
  double end = steps;
  if (speed > 0.0) end += margins.ahead / speed;
  if (turn > 0.0) end = std::min(end, largest_turn / turn);
  const Pose middle = step.X_WP0 * rotation::carried(twist, 0.5 * end);
  Region r;
  for (std::size_t k = 0; k < r.slabs.size(); ++k)
    r.slabs[k] = {middle.R.col(static_cast<int>(k)), INFINITY, -INFINITY};
  for (const Pose& X_WP : {step.X_WP0, middle, Pose(step.X_WP0 * rotation::carried(twist, end))})
    add_box(step.box_P, X_WP, r.slabs);
  add_region(step.region_W, r.slabs);
  const double half_turn =
      0.5 * end * turn;  // between the region at the end and the axes of the slabs
  const double margin = margins.margin * (std::cos(half_turn) + std::sin(half_turn)) +
                        sideways * step.box_P.size().norm();
  for (Slab& s : r.slabs) {
    s.lo -= margin;
    s.hi += margin;
  }
  r.box = box_around(r.slabs);
  return r;
}

namespace {

/// Bit l: whether a point of ball l of eight may lie between all slabs.
inline unsigned balls_between(const Balls& balls, std::size_t i, const SingleSlabs& s) {
  WideBalls b;
  load(balls, i, b);
  WideFlags in = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const WideSingle along = s.nx[k] * b.x + s.ny[k] * b.y + s.nz[k] * b.z;
    in &= (along + b.radius >= s.lo[k]) & (along - b.radius <= s.hi[k]);
  }
  return bits_of(in);
}

/// Bit l: whether place l of eight lies between all slabs.
inline unsigned places_between(const Single* x, const Single* y, const Single* z,
                               const SingleSlabs& s) {
  WidePoints p;
  TDBD_LOAD(p.x, x);
  TDBD_LOAD(p.y, y);
  TDBD_LOAD(p.z, z);
  WideFlags in;
  flag_between(p, s, in);
  return bits_of(in);
}

/// A block of the index with its columns read as eight entries; the eighth entry is meaningless.
struct WideBlock {
  WidePoints points;
  WideFlags v;
};

inline void load(const VertexGrid::Block& block, WideBlock& wide) {
  load(block, wide.points);
  TDBD_LOAD(wide.v, reinterpret_cast<const char*>(&block) + offsetof(VertexGrid::Block, v));
}

/// Writes the flagged ones of eight vertices from place i on. Overwrites up to eight places.
/// Returns the place after the last one.
inline std::size_t write_some(const WideBlock& b, unsigned in, std::size_t i, NearList& list) {
  TDBD_STORE(b.points.x, &list.x[i]);
  TDBD_STORE(b.points.y, &list.y[i]);
  TDBD_STORE(b.points.z, &list.z[i]);
  TDBD_STORE(b.v, &list.v[i]);
  if ((in & (in + 1U)) == 0) return i + static_cast<std::size_t>(std::popcount(in));
  for (; in != 0; in &= in - 1U, ++i) {
    const auto s = static_cast<std::size_t>(std::countr_zero(in));
    list.x[i] = b.points.x[s];
    list.y[i] = b.points.y[s];
    list.z[i] = b.points.z[s];
    list.v[i] = b.v[s];
  }
  return i;
}

/// Writes the vertices of the list's chains of blocks that lie between the slabs. Returns their
/// number.
TDBD_WIDE std::size_t copy_chains(const VertexGrid& grid, const SingleSlabs& slabs,
                                  const std::array<Single, 3>& origin_W, NearList& list) {
  std::size_t end = 0;
  for (int number : list.chains)
    for (; number >= 0; number = grid.block(number).next) {
      make_room(list, end);
      WideBlock b;
      load(grid.block(number), b);
      WideFlags in;
      flag_between(b.points, slabs, in);
      b.points.x -= origin_W[0];
      b.points.y -= origin_W[1];
      b.points.z -= origin_W[2];
      end = write_some(b, bits_of(in) & ((1U << grid.block(number).count) - 1U), end, list);
    }
  return end;
}

void make_from_scratch(const VertexGrid& grid, NearList& list) {
  const Vec3 centre_W = slab_box(list.region_W.slabs).centre_W;
  std::array<Single, 3> origin_W{};
  for (int k = 0; k < 3; ++k) {
    origin_W[at(k)] = static_cast<Single>(centre_W[k]);
    list.origin_W[k] = static_cast<double>(origin_W[at(k)]);
  }
  grid.find_chains(list.region_W, list.chains);
  close(list,
        copy_chains(grid, about(Vec3::Zero(), list.region_W.slabs, single_slack(list.region_W.box)),
                    origin_W, list));
  list.changes = grid.changes();
  list.size_when_made = list.v.size();
}

/// Places of removed vertices are not reused. Without this limit a list would grow indefinitely if
/// rock changes for a long time while the group stays.
bool is_too_long(const NearList& list) {
  constexpr std::size_t few = 64;
  return list.v.size() > 2 * list.size_when_made + few;
}

/// Bit l: whether change l of eight from i on placed its vertex between all slabs.
TDBD_WIDE unsigned changes_between(const VertexChanges& c, std::size_t i, const SingleSlabs& s) {
  return places_between(&c.x[i], &c.y[i], &c.z[i], s);
}

void apply_change(const VertexChanges& c, std::size_t i, bool is_between, NearList& list) {
  const std::size_t place = place_of(list, c.v[i]);
  if (place == no_place && !is_between) return;
  if (std::isnan(c.x[i])) return take_out(list, place);
  const Vec3 x_W(c.x[i], c.y[i], c.z[i]);
  if (place == no_place)
    append(list, c.v[i], x_W);
  else
    set_place(list, place, x_W);
}

/// Applies the changes from number i on to the list.
void apply(const VertexChanges& c, std::size_t i, NearList& list) {
  if (i >= c.v.size()) return;
  const SingleSlabs slabs =
      about(Vec3::Zero(), list.region_W.slabs, single_slack(list.region_W.box));
  while (i < c.v.size()) {
    const std::size_t begin = i / single_lanes * single_lanes,
                      end = std::min(begin + single_lanes, c.v.size());
    const unsigned between = changes_between(c, begin, slabs);
    for (; i < end; ++i) apply_change(c, i, (between >> (i - begin) & 1U) != 0, list);
  }
}

/// Buffers a few vertices before they are appended, because appending them one by one is slow.
struct Batch {
  static constexpr std::size_t most = 256;
  std::array<int, most> v;
  std::size_t count = 0;
};

void flush(Batch& batch, std::vector<int>& vertices) {
  vertices.insert(vertices.end(), batch.v.data(), batch.v.data() + batch.count);
  batch.count = 0;
}

/// Appends the vertices between the slabs.
TDBD_WIDE void find_between(const NearList& list, const SingleSlabs& slabs,
                            std::vector<int>& vertices) {
  Batch found;
  for (std::size_t first = 0; first * single_lanes < list.v.size(); first += single_lanes)
    for (unsigned packs = balls_between(list.balls, first, slabs); packs != 0;
         packs &= packs - 1U) {
      if (found.count + single_lanes > Batch::most) flush(found, vertices);
      const std::size_t i =
          single_lanes * (first + static_cast<std::size_t>(std::countr_zero(packs)));
      for (unsigned in = places_between(&list.x[i], &list.y[i], &list.z[i], slabs); in != 0;
           in &= in - 1U)
        found.v[found.count++] = list.v[i + static_cast<std::size_t>(std::countr_zero(in))];
    }
  flush(found, vertices);
}

}  // namespace

bool covers(const NearList& list, const VertexGrid& grid, const Region& region_W) {
  return list.changes == grid.changes() && holds(list.region_W, region_W);
}

void update_near_list(const VertexGrid& grid, const GroupStep& step, const NearListMargins& margins,
                      NearList& list) {
  constexpr int most_steps = 14;
  const ChangeJournal& journal = grid.journal();
  const double way = travel_in_step(step);
  list.remaining_travel -= way;
  const bool ends_too_near = margins.ahead > 0.0 && list.remaining_travel < 0.0;
  if (list.changes >= journal.first && !ends_too_near && holds(list.region_W, step.region_W) &&
      !is_too_long(list)) {
    apply(journal.changes, static_cast<std::size_t>(list.changes - journal.first), list);
    list.changes = journal.end();
    return;
  }
  list.window = std::min(list.window + 1, most_steps);
  list.region_W = region_ahead(step, margins, list.window);
  list.remaining_travel = (list.window - 1) * way;
  make_from_scratch(grid, list);
}

void note_changes(NearList& list, const VertexChanges& changes) { apply(changes, 0, list); }

void add_vertices_between(const NearList& list, const Region& region_W, double slack,
                          std::vector<int>& vertices) {
  find_between(list, about(list.origin_W, region_W.slabs, slack), vertices);
}

SingleSlabs about(const Vec3& origin_W, const std::array<Slab, 3>& slabs, double slack) {
  SingleSlabs single;
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    const Slab& s = slabs[k];
    single.nx[k] = static_cast<Single>(s.n.x());
    single.ny[k] = static_cast<Single>(s.n.y());
    single.nz[k] = static_cast<Single>(s.n.z());
    single.lo[k] = static_cast<Single>(s.lo - slack - s.n.dot(origin_W));
    single.hi[k] = static_cast<Single>(s.hi + slack - s.n.dot(origin_W));
  }
  return single;
}

}  // namespace tdbd::rock
