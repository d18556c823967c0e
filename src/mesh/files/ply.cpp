#include "mesh/files/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tdbd::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "records are written as they lie");

/// A facet in the file: the number of corners in one byte, then the corners.
constexpr std::size_t facet_bytes = 1 + sizeof(Triangle);
static_assert(sizeof(Triangle) == 3 * sizeof(std::int32_t));

void put_facet(char* at, const Triangle& t) {
  *at = 3;
  std::memcpy(at + 1, t.data(), sizeof t);
}

void write_facets(std::ostream& out, const std::vector<Triangle>& triangles) {
  constexpr std::size_t at_once = 4096;
  std::vector<char> some(at_once * facet_bytes);
  for (std::size_t first = 0; first < triangles.size(); first += at_once) {
    const std::size_t n = std::min(at_once, triangles.size() - first);
    for (std::size_t i = 0; i < n; ++i) put_facet(&some[i * facet_bytes], triangles[first + i]);
    out.write(some.data(), static_cast<std::streamsize>(n * facet_bytes));
  }
}

}  // namespace

void write_ply(std::ostream& out, const TriangleMesh& m, const std::vector<std::string>& comments) {
  out << "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) out << "comment " << comment << '\n';
  out << fmt::format(
      "element vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      m.positions.size(), m.triangles.size());
  out.write(reinterpret_cast<const char*>(m.positions.data()),
            static_cast<std::streamsize>(m.positions.size() * sizeof(Vec3)));
  write_facets(out, m.triangles);
}

}  // namespace tdbd::mesh
