#include "mesh/files/vtp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>

#include "core/error.hpp"
#include "io/whole_file.hpp"

namespace tdbd::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "appended data are written as they lie");
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::int32_t));

/// A data array of the file.
struct Block {
  std::string name;
  const char* type;
  int components;
  std::uint64_t bytes;
  std::function<void(std::ostream&)> write;
};

/// An XML element of the file and its arrays.
struct Group {
  std::string element;
  std::vector<Block> blocks;
};

template <class T>
Block raw_block(const std::string& name, const char* type, int components,
                const std::vector<T>& values) {
  const std::uint64_t bytes = values.size() * sizeof(T);
  const char* data = reinterpret_cast<const char*>(values.data());
  return {name, type, components, bytes,
          [=](std::ostream& out) { out.write(data, static_cast<std::streamsize>(bytes)); }};
}

/// An array of `count` 32-bit integers that are computed while they are written, 8192 at a time.
template <class Make>
Block made(const std::string& name, std::size_t count, Make make) {
  return {name, "Int32", 1, count * sizeof(std::int32_t), [=](std::ostream& out) {
            std::array<std::int32_t, 8192> some;
            for (std::size_t first = 0; first < count; first += some.size()) {
              const std::size_t n = std::min(some.size(), count - first);
              for (std::size_t i = 0; i < n; ++i) some[i] = make(first + i);
              out.write(reinterpret_cast<const char*>(some.data()),
                        static_cast<std::streamsize>(n * sizeof(std::int32_t)));
            }
          }};
}

Block block_of(const Field& f) {
  if (f.kind == FieldValues::numbers) return raw_block(f.name, "Float64", 1, f.values);
  return made(f.name, f.values.size(), [values = f.values.data()](std::size_t i) {
    return static_cast<std::int32_t>(values[i]);
  });
}

Group group_of(const char* element, const std::vector<Field>& fields, std::size_t expected) {
  Group group{element, {}};
  for (const Field& f : fields) {
    if (f.values.size() != expected)
      throw RunError(fmt::format("field '{}' has {} values for {} {}", f.name, f.values.size(),
                                 expected, element));
    group.blocks.push_back(block_of(f));
  }
  return group;
}

std::vector<Group> groups_of(const TriangleMesh& m, const std::vector<Field>& point_data,
                             const std::vector<Field>& cell_data) {
  const auto end_of = [](std::size_t i) { return static_cast<std::int32_t>(3 * (i + 1)); };
  return {{"Points", {raw_block("Points", "Float64", 3, m.positions)}},
          {"Polys",
           {raw_block("connectivity", "Int32", 1, m.triangles),
            made("offsets", m.triangles.size(), end_of)}},
          group_of("PointData", point_data, m.positions.size()),
          group_of("CellData", cell_data, m.triangles.size())};
}

/// The XML before the appended data. Each block of appended data is its byte count followed by its
/// bytes.
std::string head_of(const TriangleMesh& m, const std::vector<Group>& groups) {
  std::string head = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
      m.positions.size(), m.triangles.size());
  std::uint64_t offset = 0;
  for (const Group& g : groups) {
    head += fmt::format("<{}>\n", g.element);
    for (const Block& b : g.blocks) {
      head += fmt::format(
          R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)"
          "\n",
          b.type, b.name, b.components, offset);
      offset += sizeof b.bytes + b.bytes;
    }
    head += fmt::format("</{}>\n", g.element);
  }
  return head + "</Piece>\n</PolyData>\n";
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const TriangleMesh& m,
               const std::vector<Field>& point_data, const std::vector<Field>& cell_data) {
  const std::vector<Group> groups = groups_of(m, point_data, cell_data);
  AtomicFile file(path);
  file.stream() << head_of(m, groups) << "<AppendedData encoding=\"raw\">\n_";
  for (const Group& g : groups)
    for (const Block& b : g.blocks) {
      file.stream().write(reinterpret_cast<const char*>(&b.bytes), sizeof b.bytes);
      b.write(file.stream());
    }
  file.stream() << "\n</AppendedData>\n</VTKFile>\n";
  file.commit();
}

void write_pvd(const std::filesystem::path& path,
               const std::vector<std::pair<double, std::string>>& frames) {
  AtomicFile file(path);
  file.stream() << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                   "<Collection>\n";
  for (const auto& [time, name] : frames)
    file.stream() << fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", time, name);
  file.stream() << "</Collection>\n</VTKFile>\n";
  file.commit();
}

}  // namespace tdbd::mesh
