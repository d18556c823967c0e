#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "mesh/files/files.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/self_intersections.hpp"

namespace {

using tdbd::Vec3;
using tdbd::mesh::TriangleMesh;

constexpr const char* usage =
    "Usage: self-intersections SURFACE\n"
    "Counts the pairs of triangles of a surface (.ply, .stl, .obj, .off; open or closed) that\n"
    "intersect, by CGAL's exact predicates, and measures the triangles' shape.\n"
    "Example: self-intersections results/bit-b/rock_final.ply\n"
    "Exit codes: 0 no such pair, 1 some, 2 the file cannot be judged.\n";

constexpr std::size_t most_pairs_listed = 10;

void demand_triangles(const std::string& path, const TriangleMesh& m) {
  if (m.triangles.empty())
    throw tdbd::InputError(path + ": found no triangles, expected a surface");
  for (std::size_t v = 0; v < m.positions.size(); ++v)
    if (!m.positions[v].allFinite())
      throw tdbd::InputError(fmt::format("{}: vertex {} is not finite", path, v));
}

Vec3 centre(const TriangleMesh& m, int t) {
  const auto& [a, b, c] = m.triangles[static_cast<std::size_t>(t)];
  const auto x = [&m](int v) { return m.positions[static_cast<std::size_t>(v)]; };
  return (x(a) + x(b) + x(c)) / 3.0;
}

/// Shape quality of every triangle, worst first.
std::vector<double> qualities(const TriangleMesh& m) {
  std::vector<double> q;
  for (const auto& [a, b, c] : m.triangles)
    q.push_back(tdbd::mesh::triangle_quality(m.positions[static_cast<std::size_t>(a)],
                                             m.positions[static_cast<std::size_t>(b)],
                                             m.positions[static_cast<std::size_t>(c)]));
  std::sort(q.begin(), q.end());
  return q;
}

void print(const TriangleMesh& m, const std::vector<std::pair<int, int>>& pairs) {
  const std::vector<double> q = qualities(m);
  fmt::print("triangles                {}\n", m.triangles.size());
  fmt::print("vertices                 {}\n", m.positions.size());
  fmt::print("worst quality            {:.4f}\n", q.front());
  fmt::print("1 % quality              {:.4f}\n", q[q.size() / 100]);
  fmt::print("self-intersecting pairs  {}\n", pairs.size());
  for (std::size_t i = 0; i < std::min(pairs.size(), most_pairs_listed); ++i) {
    const Vec3 x = centre(m, pairs[i].first);
    fmt::print("  triangles {} and {} near ({:.6g}, {:.6g}, {:.6g})\n", pairs[i].first,
               pairs[i].second, x.x(), x.y(), x.z());
  }
}

/// Returns exit code 0 if no pairs intersect, otherwise 1.
int judge(const std::string& path) {
  const TriangleMesh m = tdbd::mesh::read_mesh(path, 1.0);
  demand_triangles(path, m);
  const auto pairs = tdbd::reference::self_intersections(m);
  print(m, pairs);
  return pairs.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string argument = argc == 2 ? argv[1] : "";
  if (argument == "--help" || argument == "-h") {
    std::fputs(usage, stdout);
    return 0;
  }
  if (argument.empty() || argument.front() == '-') {
    std::fputs(usage, stderr);
    return 2;
  }
  try {
    return judge(argument);
  } catch (const tdbd::InputError& e) {
    std::fprintf(stderr, "self-intersections: %s\n", e.what());
  } catch (const std::exception& e) {
    std::fprintf(stderr, "self-intersections: %s: %s\n", argument.c_str(), e.what());
  }
  return 2;
}
