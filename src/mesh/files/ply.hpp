#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// A property of an element: one value per record, or a list of values.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float64;
  std::optional<PlyType> count = std::nullopt;  ///< for a list: type of its length
};

/// An element: records of one kind, such as `vertex`.
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  long line = 0;  ///< line of the header that declares it
};

/// The content of a PLY header.
struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes before the records
  long lines = 0;        ///< lines before the records
};

std::size_t byte_size(PlyType type);

/// Reads the header, and checks that the file has enough bytes for the declared number of records
/// of every element. Throws InputError "PATH:LINE: found F, expected E".
PlyHeader read_ply_header(std::string_view bytes, const std::string& path);

/// Writes `m` as binary little-endian PLY with positions as doubles. The output equals that of
/// CGAL's writer, which writes one number at a time. Each comment is a line of the header.
void write_ply(std::ostream& out, const TriangleMesh& m,
               const std::vector<std::string>& comments = {});

}  // namespace tdbd::mesh
