#include "rock/start/space_order.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "mesh/measures.hpp"

namespace tdbd::rock {
namespace {

/// A sort key and an index. Elements with equal keys are sorted by index.
using Placed = std::pair<std::uint64_t, int>;

/// The number of a cell, with `per_cube` cells along each edge of a cube: cubes by z, y, x, then
/// cells by z, y, x.
struct CellOrder {
  static constexpr double per_cube = 4.0;
  Vec3 lo;
  double inverse_cell;

  std::uint64_t operator()(const Vec3& x) const {
    const Vec3 cell = (x - lo) * inverse_cell;
    std::uint64_t cube = 0, inside = 0;
    for (const double along : {cell.z(), cell.y(), cell.x()}) {
      const auto n = static_cast<std::uint64_t>(along);
      cube = (cube << 19) + (n >> 2);
      inside = 4 * inside + n % 4;
    }
    return 64 * cube + inside;
  }

  /// Offset along x in its cell, in 2^-32 cells.
  std::uint32_t along(const Vec3& x) const {
    const double cells = (x.x() - lo.x()) * inverse_cell;
    return static_cast<std::uint32_t>(0x1p32 * (cells - std::floor(cells)));
  }
};

/// The indices of `count` elements, sorted by place_of.
template <class PlaceOf>
std::vector<int> ordered(std::size_t count, PlaceOf place_of) {
  std::vector<Placed> placed(count);
  for (std::size_t i = 0; i < count; ++i) placed[i] = {place_of(i), static_cast<int>(i)};
  std::ranges::sort(placed);
  std::vector<int> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = placed[i].second;
  return numbers;
}

}  // namespace

std::vector<int> order_of_space(const std::vector<Vec3>& points, double cube) {
  mesh::Box box;
  for (const Vec3& x : points) box.add(x);
  const CellOrder order{box.lo, CellOrder::per_cube / cube};
  return ordered(points.size(), [&](std::size_t i) { return order(points[i]); });
}

void order_of_space(const mesh::Surface& s, double cube, std::vector<PlacedVertex>& placed,
                    std::vector<int>& order) {
  mesh::Box box;
  for (const mesh::VertexStar& star : s.stars)
    if (star.size > 0) box.add(star.x);
  const CellOrder cell{box.lo, CellOrder::per_cube / cube};
  placed.clear();
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (s.is_alive(v)) placed.push_back({cell(s.position(v)), cell.along(s.position(v)), v});
  std::ranges::sort(placed, [&](const PlacedVertex& a, const PlacedVertex& b) {
    if (a.cell != b.cell) return a.cell < b.cell;
    if (a.along != b.along) return a.along < b.along;
    const Vec3 &x = s.position(a.v), &y = s.position(b.v);
    return std::tuple(x.x(), x.y(), x.z(), a.v) < std::tuple(y.x(), y.y(), y.z(), b.v);
  });
  order.resize(placed.size());
  std::ranges::transform(placed, order.begin(), &PlacedVertex::v);
}

mesh::TriangleMesh in_order_of_space(const mesh::TriangleMesh& m, double cube) {
  mesh::TriangleMesh sorted;
  sorted.positions.reserve(m.positions.size());
  std::vector<int> number(m.positions.size());
  for (const int v : order_of_space(m.positions, cube)) {
    number[at(v)] = static_cast<int>(sorted.positions.size());
    sorted.positions.push_back(m.positions[at(v)]);
  }
  const auto least = [&](std::size_t t) {
    const auto& [a, b, c] = m.triangles[t];
    return static_cast<std::uint64_t>(std::min({number[at(a)], number[at(b)], number[at(c)]}));
  };
  sorted.triangles.reserve(m.triangles.size());
  for (const int t : ordered(m.triangles.size(), least)) {
    const auto& [a, b, c] = m.triangles[at(t)];
    sorted.triangles.push_back({number[at(a)], number[at(b)], number[at(c)]});
  }
  return sorted;
}

namespace {

/// Renumbers a list and drops vertices that were removed while they were listed.
void renumber_list(const std::vector<int>& number, std::vector<int>& vertices) {
  std::size_t kept = 0;
  for (const int v : vertices)
    if (number[at(v)] >= 0) vertices[kept++] = number[at(v)];
  vertices.resize(kept);
}

/// Renumbers the vertices in Rock::carried, pressed and left. Removed vertices are dropped.
void renumber_contacts(const std::vector<int>& number, Rock& rock) {
  for (InterpolatedDisplacement& c : rock.carried) {
    c.v = number[at(c.v)];
    for (int& v : c.from) v = number[at(v)];
  }
  for (std::vector<PressedVertex>& part : rock.pressed) {
    std::erase_if(part, [&](PressedVertex& p) { return (p.v = number[at(p.v)]) < 0; });
    std::ranges::sort(part, {}, &PressedVertex::v);
  }
  std::erase_if(rock.left, [&](ResidualVertex& l) { return (l.v = number[at(l.v)]) < 0; });
  std::ranges::sort(rock.left, comes_before);
}

}  // namespace

void renumber(Rock& rock, double cube, RenumberWork& work) {
  order_of_space(rock.surface, cube, work.placed, work.order);
  mesh::renumber(rock.surface, work.order, work.mesh);
  mesh::take_in_order(work.order, rock.last_part, work.parts);
  mesh::take_in_order(work.order, rock.touched, work.mesh.bytes);
  mesh::take_in_order(work.order, rock.moved_in, work.moved_in);
  rock.notes.of.assign(rock.surface.stars.size(), 0);  // rings begin at other neighbours now
  renumber_list(work.mesh.number, rock.touched_list);
  renumber_contacts(work.mesh.number, rock);
  rock.grid.renumber(work.mesh.number, rock.surface.vertex_slots(), work.blocks);
}

}  // namespace tdbd::rock
