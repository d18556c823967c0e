#include <fmt/format.h>

#include <cstdint>
#include <cstring>

#include "core/error.hpp"
#include "core/single.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/merged_points.hpp"

namespace tdbd::mesh {
namespace {

/// The head is 80 arbitrary bytes and the number of facets. A facet is a normal, three vertices and
/// two bytes.
constexpr std::size_t stl_head = 84, stl_facet = 50, stl_normal = 12, stl_vertex = 12;

[[noreturn]] void refuse_stl(const std::string& path, const std::string& reason) {
  throw InputError(fmt::format("{}: {}", path, reason));
}

std::size_t announced_facets(std::string_view bytes) {
  std::uint32_t facets = 0;
  std::memcpy(&facets, bytes.data() + 80, sizeof facets);
  return facets;
}

Vec3 stl_point(const char* at) {
  Single x[3];
  std::memcpy(x, at, sizeof x);
  return {x[0], x[1], x[2]};
}

}  // namespace

StlKind stl_kind(std::string_view bytes, const std::string& path) {
  const bool has_head = bytes.size() >= stl_head;
  const std::size_t expected = has_head ? stl_head + stl_facet * announced_facets(bytes) : stl_head;
  if (has_head && bytes.size() == expected) return StlKind::binary;
  if (bytes.empty() || bytes.starts_with("solid")) return StlKind::text;
  if (!has_head) refuse_stl(path, "not a valid .stl file: neither text nor a binary header");
  refuse_stl(path, fmt::format("truncated or no STL: {} bytes, expected {} for {} facets",
                               bytes.size(), expected, announced_facets(bytes)));
}

FacetFile read_binary_stl(std::string_view bytes, const std::string& path) {
  FacetFile file;
  MergedPoints points(file.points);
  const std::size_t facets = announced_facets(bytes);
  file.polygons.reserve(facets);
  for (std::size_t i = 0; i < facets; ++i) {
    std::vector<int>& corners = file.polygons.emplace_back(3);
    const char* at = bytes.data() + stl_head + stl_facet * i + stl_normal;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 x = stl_point(at + stl_vertex * k);
      if (!x.allFinite())
        refuse_stl(path,
                   fmt::format("facet {}: found a vertex at ({}, {}, {}), expected finite numbers",
                               i, x.x(), x.y(), x.z()));
      corners[k] = points.add(x);
    }
  }
  return file;
}

}  // namespace tdbd::mesh
