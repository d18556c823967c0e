#include "reference/literature/surface/mesh_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "reference/literature/surface/planar_boolean.hpp"

namespace tdbd::reference {
namespace {

using Edge = std::pair<int, int>;  // corners, the smaller first

/// Where the plane enters and leaves a triangle.
struct Passage {
  Edge out;
  Vec2 x_in, x_out;
};

/// Passages by their edge of entry, which crosses the plane from its lower to its upper side.
std::map<Edge, Passage> passages(const mesh::TriangleMesh& rock_W, const SpokePlane& plane) {
  std::map<Edge, Passage> all;
  for (const mesh::Triangle& t : rock_W.triangles) {
    Passage p;
    Edge in;
    bool passes = false;
    for (int i = 0; i < 3; ++i) {
      const int a = std::min(t[i], t[(i + 1) % 3]), b = std::max(t[i], t[(i + 1) % 3]);
      const auto x = crossing(plane, rock_W.positions[a], rock_W.positions[b]);
      if (!x) continue;
      passes = true;
      if (plane.beside(rock_W.positions[t[i]]) < 0.0)
        in = {a, b}, p.x_in = *x;
      else
        p.out = {a, b}, p.x_out = *x;
    }
    if (passes) all.emplace(in, p);
  }
  return all;
}

/// The line from rim to rim.
Outline line_through(const mesh::TriangleMesh& rock_W, const SpokePlane& plane) {
  const std::map<Edge, Passage> all = passages(rock_W, plane);
  std::set<Edge> left;
  for (const auto& [in, p] : all) left.insert(p.out);
  Outline line;
  for (const auto& [first, p] : all) {
    if (left.contains(first)) continue;
    if (!line.empty()) break;  // a second line: detected by the count below
    line.push_back(p.x_in);
    for (auto at = all.find(first); at != all.end(); at = all.find(at->second.out))
      line.push_back(at->second.x_out);
  }
  if (line.size() != all.size() + 1)
    throw std::invalid_argument("rock_section: the plane does not meet the sheet in one line");
  return line;
}

}  // namespace

PlanarRegion rock_section(const mesh::TriangleMesh& rock_W, const SpokePlane& plane,
                          const SpokeFrame& frame) {
  Outline rock = line_through(rock_W, plane);
  double top = frame.floor;
  for (const Vec2& x : rock) top = std::min(top, x.y());
  const auto beyond = [&](const Vec2& end) { return std::copysign(frame.radius, end.x()); };
  const double first = beyond(rock.front()), last = beyond(rock.back());
  if (std::abs(rock.back().x()) < frame.radius) rock.emplace_back(last, rock.back().y());
  rock.emplace_back(last, frame.floor);
  rock.emplace_back(first, frame.floor);
  if (std::abs(rock.front().x()) < frame.radius) rock.emplace_back(first, rock.front().y());
  return within({{rock, {}}},
                {{0, top}, {frame.radius, top}, {frame.radius, frame.floor}, {0, frame.floor}});
}

}  // namespace tdbd::reference
