#include "rock/section/held_vertices.hpp"

#include "mesh/search/inside.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

/// Adds the vertices that lie in the box of the group at the end of the step.
void add_within(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, double gap,
                const std::vector<int>& vertices, ContactScratch& w) {
  for (const int v : vertices) {
    const Vec3 x_P = m.X_PW1 * rock.surface.position(v);
    if (!is_within(g.box_P, x_P, gap)) continue;
    w.near.push_back(v);
    w.near_P.push_back(x_P);
  }
}

/// What the index has around the group at the end of the step.
void find_in_index(const Rock& rock, const GroupMotion& m, double gap, ContactScratch& w) {
  const Region region_W = widened(m.region_W, gap);
  const mesh::Box& box_W = region_W.box;
  w.around.clear();
  if (rock.grid.nearest_to_axis(box_W.lo.z(), box_W.hi.z()) > m.reach_W + gap) return;
  rock.grid.visit(region_W, w.chains, [&](const VertexGrid::Block& block) {
    w.around.insert(w.around.end(), block.v.begin(), block.v.begin() + block.count);
  });
}

/// The first plane that has the point outside by more than the gap; the number of columns if there
/// is none.
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

/// Tests first the plane that rejected the last vertex.
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
  if (cut.groups[i].knows_touching && gap <= cut.contact_gap) {
    add_within(rock, g, m, gap, cut.groups[i].near.touching, w);
    for (std::size_t k = 0; k < cut.groups.size(); ++k)
      if (const GroupCut& other = cut.groups[k]; k != i && other.moved_box_W.overlaps(box_W))
        add_within(rock, g, m, gap, other.moved_in_step, w);
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

}  // namespace tdbd::rock
