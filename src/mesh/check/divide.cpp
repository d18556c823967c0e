#include "mesh/check/divide.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "mesh/check/topology.hpp"

namespace tdbd::mesh {
namespace {

/// Tracks the edges of the facets added so far, and whether these facets form a closed surface.
class Closing {
 public:
  void add(const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      Uses& uses = uses_[std::minmax({from, to})];
      unfinished_ -= is_unfinished(uses);
      ++(from < to ? uses.forward : uses.backward);
      unfinished_ += is_unfinished(uses);
    }
  }
  bool is_closed() const { return unfinished_ == 0; }

 private:
  struct Uses {
    int forward = 0, backward = 0;
  };
  static int is_unfinished(const Uses& u) {
    return u.forward + u.backward > 0 && (u.forward != 1 || u.backward != 1) ? 1 : 0;
  }
  std::map<std::pair<int, int>, Uses> uses_;
  int unfinished_ = 0;
};

/// Groups facet numbers into runs. A run ends where its facets form a closed surface.
std::vector<std::vector<int>> closing_runs(const std::vector<Triangle>& facets) {
  std::vector<std::vector<int>> runs;
  Closing closing;
  for (int i = 0; i < static_cast<int>(facets.size()); ++i) {
    if (closing.is_closed()) {
      closing = Closing();
      runs.emplace_back();
    }
    runs.back().push_back(i);
    closing.add(facets[at(i)]);
  }
  return runs;
}

}  // namespace

TriangleMesh submesh(const TriangleMesh& m, const std::vector<int>& triangles) {
  std::vector<int> used;
  for (const int i : triangles)
    used.insert(used.end(), m.triangles[at(i)].begin(), m.triangles[at(i)].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  TriangleMesh part;
  part.positions.reserve(used.size());
  for (const int v : used) part.positions.push_back(m.positions[at(v)]);
  part.triangles.reserve(triangles.size());
  for (const int i : triangles) {
    Triangle t = m.triangles[at(i)];
    for (int& v : t)
      v = static_cast<int>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    part.triangles.push_back(t);
  }
  return part;
}

std::vector<Triangle> by_first_of_equals(const TriangleMesh& m) {
  std::map<std::array<double, 3>, int> first;
  std::vector<int> of_vertex;
  of_vertex.reserve(m.positions.size());
  for (const Vec3& x : m.positions)
    of_vertex.push_back(
        first.try_emplace({x.x(), x.y(), x.z()}, static_cast<int>(of_vertex.size())).first->second);
  std::vector<Triangle> triangles = m.triangles;
  for (Triangle& t : triangles)
    for (int& v : t) v = of_vertex[at(v)];
  return triangles;
}

std::vector<TriangleMesh> divide(const TriangleMesh& m) {
  const std::vector<Triangle> facets = by_first_of_equals(m);
  std::vector<TriangleMesh> pieces;
  for (const std::vector<int>& run : closing_runs(facets)) {
    std::vector<Triangle> of_run;
    of_run.reserve(run.size());
    for (const int i : run) of_run.push_back(facets[at(i)]);
    for (std::vector<int>& piece : connected_pieces(of_run)) {
      for (int& i : piece) i = run[at(i)];
      pieces.push_back(submesh(m, piece));
    }
  }
  return pieces;
}

}  // namespace tdbd::mesh
