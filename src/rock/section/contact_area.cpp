#include "rock/section/contact_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "rock/cut/cut_rock.hpp"
#include "rock/section/contact_end.hpp"
#include "rock/section/held_vertices.hpp"

namespace tdbd::rock {
namespace {

/// Sums for a ContactPatch, in the frame P.
struct PatchSums {
  double area = 0.0, weight = 0.0;                             // m2; weight: sum of w A
  Vec3 area_vector_P = Vec3::Zero(), moment_P = Vec3::Zero();  // m2, m3

  void add(const Vec3& vector_P, const Vec3& middle_P, double share) {
    const double a = vector_P.norm();
    area += a;
    weight += share * a;
    area_vector_P += share * vector_P;
    moment_P += share * a * middle_P;
  }
};

struct ContactSums {
  PatchSums below, sides;
  std::array<PatchSums, 6> facing{};  // for ContactDivision::by_direction
};

/// The direction (-x, x, -y, y, -z, z) that the part's surface faces most, given the area vector of
/// the rock; the first of equal ones.
std::size_t faced_direction(const Vec3& area_vector_P) {
  Eigen::Index axis = 0;
  area_vector_P.cwiseAbs().maxCoeff(&axis);
  return static_cast<std::size_t>(2 * axis + (area_vector_P[axis] < 0.0 ? 1 : 0));
}

/// State of the computation for one part.
struct Contact {
  const Rock& rock;
  const PressingPart& part;
  int index;  ///< of the part
  ContactDivision division;
  ContactScratch& w;

  ContactScratch::Place& place(int v) const { return w.places[at(w.index[at(v)])]; }
  bool is_seen(int v) const { return w.mark[at(v)] == w.stamp; }

  /// Adds a vertex beside the held ones to `places`.
  void see(const GroupMotion& m, int v) const {
    if (is_seen(v)) return;
    w.mark[at(v)] = w.stamp;
    w.index[at(v)] = static_cast<int>(w.places.size());
    const Vec3 x_P = m.X_PW1 * rock.surface.position(v);
    ContactScratch::Place p{x_P};
    const PressedVertex* before = find_pressed(w.inherited, v);
    if (before != nullptr) {
      p.d_P = m.X_PW1.R * before->d_W;
      p.is_inside = is_lee(v, p) && is_inside(part, x_P - p.d_P);
      if (before->hold == ContactStatus::made)
        w.pressed.push_back(*before);
      else if (p.is_inside)
        w.pressed.push_back({v, before->d_W, ContactStatus::left});
      else
        p.d_P = Vec3::Zero();
    }
    w.places.push_back(p);
  }

  /// Whether a vertex that the part does not hold was left on its lee side.
  bool is_lee(int v, ContactScratch::Place& p) const {
    if (!p.is_lee) p.is_lee = rock.last_part[at(v)] == index && is_on_lee_side(part, p.x_P);
    return *p.is_lee;
  }

  bool is_pressed(int v) const { return place(v).is_held && !*place(v).is_lee; }
  bool is_inner(int v) const { return is_pressed(v) || place(v).is_inside; }

  /// The end of the contact on the edge from a pressed vertex, or from one inside the part, to any
  /// other vertex.
  const ContactEnd& end(int in, int out) const {
    const auto hash = static_cast<std::size_t>(in) * 31 + static_cast<std::size_t>(out);
    ContactScratch::KnownEnd& known = w.ends[hash % w.ends.size()];
    if (known.stamp != w.stamp || known.in != in || known.out != out)
      known = {in, out, w.stamp, find_end(in, out)};
    return known.end;
  }

  ContactEnd find_end(int in, int out) const {
    const ContactScratch::Place& p = place(in);
    ContactScratch::Place& q = place(out);
    if (!is_pressed(in)) return end_beside_lee_side(part, {p.x_P, p.d_P}, q.x_P - q.d_P);
    if (is_lee(out, q)) return end_at_lee_side(part, {p.x_P, p.d_P}, q.x_P, q.x_P - q.d_P);
    if (is_moved_now(rock, out))  // by another part
      return end_on_undisturbed_rock(part, {p.x_P, Vec3::Zero()}, q.x_P);
    return end_on_undisturbed_rock(part, {p.x_P, p.d_P}, q.x_P - q.d_P);
  }

  /// Adds the contact in one triangle, including its sides: the polygon of its pressed corners and
  /// its ends, counter-clockwise.
  void add(const std::array<int, 3>& v, ContactSums& sums) const {
    std::array<Vec3, 7> corners_P;  // on the part's lower surface
    std::size_t n = 0;
    ContactEnd last;        // where the polygon leaves the last inner corner's edge
    int from = -1;          // that corner
    std::size_t first = 0;  // the polygon begins at an inner corner after one that is not
    for (std::size_t i = 0; i < 3; ++i)
      if (is_inner(v[i]) && !is_inner(v[(i + 2) % 3])) first = i;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = v[(first + k) % 3], b = v[(first + k + 1) % 3];
      if (is_pressed(a)) corners_P[n++] = place(a).x_P;
      if (is_inner(a) && is_inner(b) && is_pressed(a) != is_pressed(b))
        corners_P[n++] = (is_pressed(a) ? end(a, b) : end(b, a)).x_P;
      if (is_inner(a) && !is_inner(b)) {
        last = end(a, b);
        from = a;
        if (is_pressed(a)) corners_P[n++] = last.foot_P;
      }
      if (!is_inner(a) && is_inner(b)) {
        const ContactEnd back = end(b, a);
        const std::size_t before = n;
        add_side(last, back, place(from).d_P, corners_P, n, sums);
        if (!is_pressed(from) || !is_pressed(b)) n = before;
        if (is_pressed(b)) corners_P[n++] = back.foot_P;
      }
    }
    add_polygon({corners_P.data(), n}, sums.below,
                division == ContactDivision::by_direction ? &sums.facing : nullptr);
  }

  /// Adds the sides between the two ends of a triangle, from their lower edges up. At an edge
  /// between two sides, both the lower and the upper boundary have a corner.
  void add_side(const ContactEnd& a, const ContactEnd& b, const Vec3& d_P,
                std::array<Vec3, 7>& corners_P, std::size_t& n, ContactSums& sums) const {
    std::array<Vec3, 7> side_P;
    std::size_t m = 0;
    const auto put = [&](const Vec3& x_P) {
      if (m == 0 || x_P != side_P[m - 1]) side_P[m++] = x_P;
    };
    const bool a_rises = a.foot_P != a.x_P, b_rises = b.foot_P != b.x_P;
    std::array<Vec3, 2> edge_P;
    if (edge_between(part, a, b, d_P, edge_P)) {
      corners_P[n++] = foot_of_edge(a, b, edge_P, d_P);
      if (!a_rises) put(corners_P[n - 1]);
      if (a_rises)
        for (const Vec3& x_P : {a.foot_P, a.x_P, edge_P[0]}) put(x_P);
      if (b_rises)
        for (const Vec3& x_P : {edge_P[1], b.x_P, b.foot_P}) put(x_P);
      if (a_rises) put(corners_P[n - 1]);
    } else {
      for (const Vec3& x_P : {a.foot_P, a.x_P, b.x_P, b.foot_P}) put(x_P);
    }
    add_polygon({side_P.data(), m}, sums.sides);
  }

  /// The lower end of the edge between two sides, at the level of the lower foot.
  static Vec3 foot_of_edge(const ContactEnd& a, const ContactEnd& b,
                           const std::array<Vec3, 2>& edge_P, const Vec3& d_P) {
    const Vec3 u = d_P.normalized();
    const double level = std::max(u.dot(a.foot_P), u.dot(b.foot_P));
    return edge_P[0] + (level - u.dot(edge_P[0])) * u;
  }

  void add_polygon(std::span<const Vec3> x_P, PatchSums& sums,
                   std::array<PatchSums, 6>* facing = nullptr) const {
    for (std::size_t k = 2; k < x_P.size(); ++k) {
      const Vec3 area_vector_P = mesh::area_vector(x_P[0], x_P[k - 1], x_P[k]);
      const Vec3 middle_P = (x_P[0] + x_P[k - 1] + x_P[k]) / 3.0;
      const double share = share_at(middle_P);
      sums.add(area_vector_P, middle_P, share);
      if (facing != nullptr)
        (*facing)[faced_direction(area_vector_P)].add(area_vector_P, middle_P, share);
    }
  }

  double share_at(const Vec3& x_P) const {
    return part.ramp > 0.0 ? stress_share(part, x_P, nearest_normal(part, x_P)) : 1.0;
  }
};

/// Area vectors point out of the rock, normals of the part into it.
ContactPatch patch_of(const PressingPart& part, const Pose& X_WP, const PatchSums& sums) {
  ContactPatch patch{sums.area};
  const double norm = sums.area_vector_P.norm();
  if (!(sums.weight > 0.0 && norm > 0.0)) return patch;
  const Vec3 middle_P = sums.moment_P / sums.weight;
  const double share = stress_share(part, middle_P, -sums.area_vector_P / norm);
  patch.centroid_W = X_WP * middle_P;
  if (share > 0.0) patch.area_vector_W = X_WP.R * sums.area_vector_P / share;
  return patch;
}

/// Adds the triangles around a vertex that is held, or inside. Each triangle is added at the lowest
/// of its held vertices, or if it has none, at the lowest that is inside.
void add_around(const GroupMotion& m, const Contact& c, int v, ContactSums& sums) {
  const mesh::Surface& s = c.rock.surface;
  const mesh::VertexStar& star = s.star(v);
  const int* ring = s.ring(star);
  for (int i = 0; i < star.size; ++i) c.see(m, ring[i]);
  const bool is_held = c.place(v).is_held;
  const auto comes_first = [&](int other) {
    const ContactScratch::Place& p = c.place(other);
    return is_held ? p.is_held && other < v : p.is_held || (p.is_inside && other < v);
  };
  // Rings may begin at any neighbour, so the first triangle is the one after the lowest vertex.
  const auto first = star.open ? 0 : std::min_element(ring, ring + star.size) - ring;
  for (int i = 0; i < star.size - star.open; ++i) {
    const int a = ring[(first + i) % star.size], b = ring[(first + i + 1) % star.size];
    if (!comes_first(a) && !comes_first(b)) c.add({v, a, b}, sums);
  }
}

/// Sums in ascending order of vertex numbers, so that sums do not depend on the index's order.
PartContact sum_contact(const GroupMotion& m, const Contact& c) {
  const mesh::Surface& s = c.rock.surface;
  PartContact contact;
  contact.distance = std::numeric_limits<double>::infinity();
  for (const int v : c.w.held) {
    ContactScratch::Place& place = c.place(v);
    const Touch touched = touch(c.part, place.x_P);
    place.is_lee = touched.is_lee;
    place.is_inside =
        touched.is_lee && !place.d_P.isZero(0.0) && is_inside(c.part, place.x_P - place.d_P);
    if (touched.is_lee) continue;
    contact.distance = std::min(contact.distance, touched.rise);
    place.x_P = touched.x_P;
  }
  if (!std::isfinite(contact.distance)) return {};
  ContactSums sums;
  for (const int v : c.w.held) add_around(m, c, v, sums);
  // Triangles without a held vertex.
  for (const PressedVertex& before : c.w.inherited) {
    if (before.hold == ContactStatus::made || !s.is_alive(before.v)) continue;
    c.see(m, before.v);
    if (!c.place(before.v).is_held && c.place(before.v).is_inside) add_around(m, c, before.v, sums);
  }
  contact.below = patch_of(c.part, m.X_WP1, sums.below);
  contact.sides = patch_of(c.part, m.X_WP1, sums.sides);
  if (c.division == ContactDivision::by_direction)
    for (std::size_t i = 0; i < sums.facing.size(); ++i)
      contact.facing[i] = patch_of(c.part, m.X_WP1, sums.facing[i]);
  return contact;
}

/// Keeps vertices that maintenance made near the group and that no part has held since.
void keep_maintenance_vertices(const Rock& rock, const CuttingGroup& g, const GroupMotion& m,
                               ContactScratch& w) {
  constexpr double around = 0.5;  // times the group's size
  const double margin = around * g.box_P.size().norm();
  for (const PressedVertex& p : w.inherited)
    if (p.hold == ContactStatus::made && w.mark[at(p.v)] != w.stamp && rock.surface.is_alive(p.v) &&
        is_within(g.box_P, m.X_PW1 * rock.surface.position(p.v), margin))
      w.pressed.push_back(p);
  std::ranges::sort(w.pressed, {}, &PressedVertex::v);
}

/// The contact by triangles whose vertices are all held. Each is added at its lowest vertex.
PartContact sum_whole_triangles(const Rock& rock, ContactScratch& w) {
  std::ranges::sort(w.held);
  ContactPatch patch;
  for (const int v : w.held) {
    const mesh::VertexStar& star = rock.surface.star(v);
    const int* ring = rock.surface.ring(star);
    const auto comes_later = [&](int u) { return u > v && w.mark[at(u)] == w.stamp; };
    if (std::count_if(ring, ring + star.size, comes_later) < 2) continue;
    const auto first = star.open ? 0 : std::min_element(ring, ring + star.size) - ring;
    for (int i = 0; i < star.size - star.open; ++i) {
      const int a = ring[(first + i) % star.size], b = ring[(first + i + 1) % star.size];
      if (!comes_later(a) || !comes_later(b)) continue;
      const Vec3 &x = rock.surface.position(v), &y = rock.surface.position(a),
                 &z = rock.surface.position(b);
      const Vec3 area_vector_W = mesh::area_vector(x, y, z);
      const double area = area_vector_W.norm();
      patch.area += area;
      patch.area_vector_W += area_vector_W;
      patch.centroid_W += area / 3.0 * (x + y + z);
    }
  }
  if (patch.area > 0.0) patch.centroid_W /= patch.area;
  return {patch, {}, {}, 0.0};
}

/// Computes the contacts of the parts of one group.
void measure_group(Rock& rock, const CuttingBit& bit, const CutWorkspace& cut, std::size_t i,
                   const ContactOptions& options, std::span<const InterpolatedDisplacement> carried,
                   ContactScratch& w, std::vector<PartContact>& contact_by_part) {
  const CuttingGroup& g = bit.groups[i];
  const GroupMotion& m = cut.motions[i];
  const double gap = options.gap;
  find_near(rock, bit, cut, i, gap, w);
  w.mark.resize(rock.surface.stars.size(), 0);
  for (std::size_t k = 0; k < g.parts.size();) {
    const std::size_t from = k;
    const int part = g.parts[k].part;
    ++w.stamp;
    w.held.clear();
    for (; k < g.parts.size() && g.parts[k].part == part; ++k) hold(rock, g, g.parts[k], gap, w);
    if (w.held.empty()) {
      rock.pressed[at(part)].clear();
      continue;
    }
    const ContactOfPart how = options.by_part.empty() ? ContactOfPart{} : options.by_part[at(part)];
    if (how.rule == ContactRule::whole_triangles) {
      contact_by_part[at(part)] = sum_whole_triangles(rock, w);
      rock.pressed[at(part)].clear();
      continue;
    }
    update_held(rock, m, cut.groups[i], part, carried, w);
    const PressingPart pressing{
        {g.parts.data() + from, k - from}, m.X_PW1 * m.X_WP0, gap, how.ramp, how.excluded_normal_P};
    contact_by_part[at(part)] = sum_contact(m, {rock, pressing, part, how.division, w});
    keep_maintenance_vertices(rock, g, m, w);
    rock.pressed[at(part)].assign(w.pressed.begin(), w.pressed.end());
  }
}

}  // namespace

void contact_areas(Rock& rock, const CuttingBit& bit, const CutWorkspace& cut,
                   const ContactOptions& options, ContactWork& work,
                   std::vector<PartContact>& contact_by_part) {
  contact_by_part.assign(at(bit.part_count), {});
  rock.pressed.resize(at(bit.part_count));
  keep_relevant_operations(rock, work);
  apply_residues(rock, work.places_W);
  parallel_for(static_cast<int>(bit.groups.size()), [&](int i) {
    if (bit.groups[at(i)].kind == GroupKind::parts)
      measure_group(rock, bit, cut, at(i), options, work.carried, work.scratch.local(),
                    contact_by_part);
  });
  undo_residues(rock, work.places_W);
  rock.carried.clear();
}

}  // namespace tdbd::rock
