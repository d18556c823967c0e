#include "rock/cut/left_rock.hpp"

#include <algorithm>
#include <array>

#include "mesh/search/inside.hpp"

namespace tdbd::rock {
namespace {

int owner_of(const CuttingGroup& g) { return g.parts.front().part; }

auto place_of(std::vector<LeftVertex>& left, int v, int part) {
  return std::ranges::lower_bound(left, LeftVertex{v, part}, comes_before);
}

bool is_at(const std::vector<LeftVertex>& left, std::vector<LeftVertex>::const_iterator it, int v,
           int part) {
  return it != left.end() && it->v == v && it->part == part;
}

Vec3 left_of(const std::vector<LeftVertex>& left, int v, int part) {
  const auto it = std::ranges::lower_bound(left, LeftVertex{v, part}, comes_before);
  return is_at(left, it, v, part) ? it->left_W : Vec3(Vec3::Zero());
}

/// Whether a point is inside a part or on its surface.
bool is_in(const CuttingPart& part, const Vec3& x_P) {
  if (part.tree_P) return mesh::inside(*part.tree_P, x_P);
  for (std::size_t i = 0; i < part.solid_P.planes; ++i)
    if (mesh::normal(part.solid_P, i).dot(x_P) > part.solid_P.b[i] + part.depth) return false;
  return true;
}

bool is_in(const CuttingGroup& g, const Vec3& x_P) {
  return std::ranges::any_of(g.parts, [&](const CuttingPart& part) { return is_in(part, x_P); });
}

/// The parts whose passes include one of the vertices of an operation.
void find_parts(const std::vector<LeftVertex>& left, const CarriedDisplacement& c,
                std::vector<int>& parts) {
  parts.clear();
  for (const int v : {c.v, c.from[0], c.from[1], c.from[2]})
    for (auto it = std::ranges::lower_bound(left, LeftVertex{v, -1}, comes_before);
         it != left.end() && it->v == v; ++it)
      if (std::ranges::find(parts, it->part) == parts.end()) parts.push_back(it->part);
}

void carry(const CarriedDisplacement& c, std::vector<LeftVertex>& left, std::vector<int>& parts) {
  find_parts(left, c, parts);
  for (const int part : parts) {
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      if (c.weight[i] > 0.0) mean += c.weight[i] * left_of(left, c.from[i], part);
    const auto it = place_of(left, c.v, part);
    if (is_at(left, it, c.v, part))
      it->left_W = mean;
    else
      left.insert(it, {c.v, part, mean});
  }
}

void find_inside(const Rock& rock, const CuttingBit& bit, const std::vector<GroupMotion>& motions,
                 PassWork& w) {
  w.group_of_part.assign(at(bit.part_count), -1);
  for (std::size_t i = 0; i < bit.groups.size(); ++i)
    if (bit.groups[i].leaves == Leaves::a_share)
      w.group_of_part[at(owner_of(bit.groups[i]))] = static_cast<int>(i);
  w.is_inside.resize(rock.left.size());
  for (std::size_t i = 0; i < rock.left.size(); ++i) {
    const LeftVertex& l = rock.left[i];
    const int group = w.group_of_part[at(l.part)];
    w.is_inside[i] =
        group >= 0 && rock.surface.is_alive(l.v) &&
        is_in(bit.groups[at(group)], motions[at(group)].X_PW0 * rock.surface.position(l.v));
  }
}

/// Whether a neighbour in the same pass is inside the part.
bool is_beside_inside(const Rock& rock, const LeftVertex& l,
                      const std::vector<std::uint8_t>& is_inside) {
  if (!rock.surface.is_alive(l.v)) return false;
  const mesh::VertexStar& star = rock.surface.star(l.v);
  const int* ring = rock.surface.ring(star);
  return std::any_of(ring, ring + star.size, [&](int v) {
    const auto it = std::ranges::lower_bound(rock.left, LeftVertex{v, l.part}, comes_before);
    return is_at(rock.left, it, v, l.part) &&
           is_inside[static_cast<std::size_t>(it - rock.left.begin())] != 0;
  });
}

}  // namespace

Vec3 left_before(const Rock& rock, const CuttingGroup& g, int v) {
  return left_of(rock.left, v, owner_of(g));
}

void note_left(Rock& rock, const CuttingGroup& g, const CuttingPart& part, int v, const Vec3& d_W) {
  const int owner = g.kind == GroupKind::parts ? owner_of(g) : -1;
  for (auto it = place_of(rock.left, v, -1); it != rock.left.end() && it->v == v; ++it) {
    if (it->part == owner) continue;
    const Vec3 rest_W = it->left_W - d_W;
    it->left_W = rest_W.dot(it->left_W) > 0.0 ? rest_W : Vec3(Vec3::Zero());
  }
  if (owner < 0 || part.share == 1.0) return;
  const Vec3 more_W = (1.0 / part.share - 1.0) * d_W;
  const auto it = place_of(rock.left, v, owner);
  if (is_at(rock.left, it, v, owner))
    it->left_W += more_W;
  else
    rock.left.insert(it, {v, owner, more_W});
}

void begin_passes(Rock& rock, const CuttingBit& bit, const std::vector<GroupMotion>& motions,
                  PassWork& w) {
  std::vector<LeftVertex>& left = rock.left;
  for (const CarriedDisplacement& c : rock.carried)
    if (c.v >= 0) carry(c, left, w.parts);
  if (rock.pressed.empty()) rock.carried.clear();
  find_inside(rock, bit, motions, w);
  w.goes_on.resize(left.size());
  for (std::size_t i = 0; i < left.size(); ++i)
    w.goes_on[i] = w.is_inside[i] != 0 || is_beside_inside(rock, left[i], w.is_inside);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (w.goes_on[i] != 0) left[kept++] = left[i];
  left.resize(kept);
}

void regroup_left(Rock& rock, const CuttingBit& bit) {
  for (LeftVertex& l : rock.left)
    for (const CuttingGroup& g : bit.groups)
      if (g.kind == GroupKind::parts &&
          std::ranges::find(g.parts, l.part, &CuttingPart::part) != g.parts.end())
        l.part = owner_of(g);
  std::ranges::sort(rock.left, comes_before);
}

void show_passed(Rock& rock, std::vector<Vec3>& places_W) {
  places_W.clear();
  for (const LeftVertex& l : rock.left) {
    places_W.push_back(rock.surface.position(l.v));
    const bool is_first = places_W.size() == 1 || (&l)[-1].v != l.v;
    if (is_first) rock.surface.place(l.v, places_W.back() + l.left_W);
  }
}

void put_back(Rock& rock, const std::vector<Vec3>& places_W) {
  for (std::size_t i = rock.left.size(); i > 0; --i)
    rock.surface.place(rock.left[i - 1].v, places_W[i - 1]);
}

}  // namespace tdbd::rock
