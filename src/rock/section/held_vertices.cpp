#include "rock/section/held_vertices.hpp"

#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

/// Adds the vertices that lie in the group's box at the end of the step.
void add_within(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, double gap,
                const std::vector<int>& vertices, ContactScratch& w) {
  for (const int v : vertices) {
    const Vec3 x_P = m.X_PW1 * rock.surface.position(v);
    if (!is_within(g.box_P, x_P, gap)) continue;
    w.near.push_back(v);
    w.near_P.push_back(x_P);
  }
}

/// Finds the vertices in the index around the group at the end of the step.
void find_in_index(const Rock& rock, const GroupMotion& m, double gap, ContactScratch& w) {
  const Region region_W = widened(m.region_W, gap);
  const mesh::Box& box_W = region_W.box;
  w.around.clear();
  if (rock.grid.nearest_to_axis(box_W.lo.z(), box_W.hi.z()) > m.reach_W + gap) return;
  rock.grid.visit(region_W, w.chains, [&](const VertexGrid::Block& block) {
    w.around.insert(w.around.end(), block.v.begin(), block.v.begin() + block.count);
  });
}

/// The first plane that has the point outside by more than the gap, or the number of columns if
/// there is none.
TDBD_WIDE std::size_t plane_between(const mesh::ConvexSolid& s, const Vec3& x_P, double gap) {
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide out = x * x_P.x() + y * x_P.y() + z * x_P.z() - b;
    for (std::size_t l = 0; l < lanes; ++l)
      if (out[l] > gap) return i + l;
  }
  return s.b.size();
}

/// Tests the plane first that rejected the previous vertex.
bool touches(const mesh::ConvexSolid& solid, const Vec3& x_P, double gap, std::size_t& plane) {
  if (plane < solid.planes && mesh::normal(solid, plane).dot(x_P) - solid.b[plane] > gap)
    return false;
  const std::size_t between = plane_between(solid, x_P, gap);
  if (between == solid.b.size()) return true;
  plane = between;
  return false;
}

bool touches(const CuttingPart& part, const Vec3& x_P, double gap, std::size_t& plane) {
  if (!part.tree_P) return touches(part.solid_P, x_P, gap, plane);
  return mesh::inside(*part.tree_P, x_P) || mesh::distance(*part.tree_P, x_P) <= gap;
}

/// Sum of the displacements of a vertex by one part in this step, m.
Vec3 moved_by(const GroupCut& cut, int part, int v) {
  Vec3 sum = Vec3::Zero();
  for (auto m = std::ranges::lower_bound(cut.moves, v, {}, &VertexMove::v);
       m != cut.moves.end() && m->v == v; ++m)
    if (m->part == part) sum += m->d_W;
  return sum;
}

Vec3 displacement_of(const std::vector<PressedVertex>& pressed, int v) {
  const PressedVertex* found = find_pressed(pressed, v);
  return found != nullptr ? found->d_W : Vec3(Vec3::Zero());
}

/// Sets the displacement of a vertex in a sorted list.
void set_pressed(std::vector<PressedVertex>& pressed, const PressedVertex& p) {
  const auto place = std::ranges::lower_bound(pressed, p.v, {}, &PressedVertex::v);
  if (place != pressed.end() && place->v == p.v)
    *place = p;
  else
    pressed.insert(place, p);
}

/// What the part pressed after the last cut, updated by the operations of maintenance since.
void carry(const Rock& rock, int part, std::span<const InterpolatedDisplacement> carried,
           std::vector<PressedVertex>& pressed) {
  pressed = rock.pressed[at(part)];
  if (pressed.empty()) return;
  for (const InterpolatedDisplacement& c : carried) {
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      if (c.weight[i] > 0.0) mean += c.weight[i] * displacement_of(pressed, c.from[i]);
    const PressedVertex* known = find_pressed(pressed, c.v);
    if (known != nullptr || !mean.isZero(0.0))
      set_pressed(pressed, {c.v, mean, known != nullptr ? known->hold : ContactStatus::made});
  }
}

}  // namespace

bool is_within(const mesh::Box& box, const Vec3& x, double gap) {
  return (x.array() >= box.lo.array() - gap).all() && (x.array() <= box.hi.array() + gap).all();
}

void find_near(const Rock& rock, const CuttingBit& bit, const CutWorkspace& cut, std::size_t i,
               double gap, ContactScratch& w) {
  const CuttingGroup& g = bit.groups[i];
  const GroupMotion& m = cut.motions[i];
  const mesh::Box box_W = widened(m.region_W, gap).box;
  w.near.clear();
  w.near_P.clear();
  if (cut.groups[i].touching_is_complete && gap <= cut.contact_gap) {
    add_within(rock, g, m, gap, cut.groups[i].near.touching, w);
    visit_overlapping(cut.moved_boxes, box_W, [&](std::size_t k) {
      if (const GroupCut& other = cut.groups[k]; k != i && other.moved_box_W.overlaps(box_W))
        add_within(rock, g, m, gap, other.moved_in_step, w);
    });
  } else {
    find_in_index(rock, m, gap, w);
    add_within(rock, g, m, gap, w.around, w);
  }
  for (const int v : cut.groups[i].moved_in_step) {
    w.near.push_back(v);
    w.near_P.push_back(m.X_PW1 * rock.surface.position(v));
  }
}

void hold(const Rock& rock, const CuttingGroup& g, const CuttingPart& part, double gap,
          ContactScratch& w) {
  std::size_t plane = 0;
  for (std::size_t i = 0; i < w.near.size(); ++i) {
    const int v = w.near[i];
    if (w.mark[at(v)] == w.stamp) continue;
    const bool moved = rock.last_part[at(v)] == part.part && is_moved_now(rock, v);
    if (!moved && (!touches(part, w.near_P[i], gap, plane) ||
                   is_far_from(g, w.near_P[i], gaps_around_hull * gap)))
      continue;
    w.mark[at(v)] = w.stamp;
    w.held.push_back(v);
  }
}

const PressedVertex* find_pressed(const std::vector<PressedVertex>& pressed, int v) {
  const auto found = std::ranges::lower_bound(pressed, v, {}, &PressedVertex::v);
  return found != pressed.end() && found->v == v ? &*found : nullptr;
}

void keep_relevant_operations(const Rock& rock, ContactWork& work) {
  work.carried.clear();
  if (rock.carried.empty()) return;
  work.mark.resize(rock.surface.stars.size(), 0);
  ++work.stamp;
  for (const std::vector<PressedVertex>& part : rock.pressed)
    for (const PressedVertex& p : part) work.mark[at(p.v)] = work.stamp;
  const auto is_marked = [&](int v) { return v >= 0 && work.mark[at(v)] == work.stamp; };
  for (const InterpolatedDisplacement& c : rock.carried) {
    if (c.v < 0 || !(is_marked(c.v) || std::ranges::any_of(c.from, is_marked))) continue;
    work.mark[at(c.v)] = work.stamp;
    work.carried.push_back(c);
  }
}

void update_held(const Rock& rock, const GroupMotion& m, const GroupCut& cut, int part,
                 std::span<const InterpolatedDisplacement> carried, ContactScratch& w) {
  std::ranges::sort(w.held);
  carry(rock, part, carried, w.inherited);
  w.pressed.clear();
  w.places.clear();
  w.index.resize(w.mark.size());
  for (const int v : w.held) {
    const PressedVertex* before = find_pressed(w.inherited, v);
    Vec3 d_W = moved_by(cut, part, v);
    if (before != nullptr && before->hold != ContactStatus::left) d_W += before->d_W;
    w.pressed.push_back({v, d_W, ContactStatus::held});
    w.index[at(v)] = static_cast<int>(w.places.size());
    w.places.push_back({m.X_PW1 * rock.surface.position(v), m.X_PW1.R * d_W, true});
  }
}

}  // namespace tdbd::rock
