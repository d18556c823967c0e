#include "mesh/files/vtp.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <span>

#include "core/error.hpp"
#include "core/whole_file.hpp"

namespace tdbd::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "appended data are written as they lie");
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::int32_t));

/// The XML header and the bytes that its DataArray elements refer to.
struct Document {
  std::string head;
  std::string appended;
};

/// Appends one block (byte count, bytes) and the element that names its offset.
template <class T>
void add_array(Document& doc, const std::string& name, const char* type, int components,
               std::span<const T> values) {
  doc.head += fmt::format(
      R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)"
      "\n",
      type, name, components, doc.appended.size());
  const std::uint64_t bytes = values.size_bytes();
  doc.appended.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  doc.appended.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

void add_fields(Document& doc, const char* element, const std::vector<Field>& fields,
                std::size_t expected) {
  doc.head += fmt::format("<{}>\n", element);
  for (const Field& f : fields) {
    if (f.values.size() != expected)
      throw RunError(fmt::format("field '{}' has {} values for {} {}", f.name, f.values.size(),
                                 expected, element));
    add_array<double>(doc, f.name, "Float64", 1, f.values);
  }
  doc.head += fmt::format("</{}>\n", element);
}

void add_polygons(Document& doc, const TriangleMesh& m) {
  std::vector<std::int32_t> ends(m.triangles.size());
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::int32_t>(3 * (i + 1));
  doc.head += "<Polys>\n";
  add_array<Triangle>(doc, "connectivity", "Int32", 1, m.triangles);
  add_array<std::int32_t>(doc, "offsets", "Int32", 1, ends);
  doc.head += "</Polys>\n";
}

Document document_of(const TriangleMesh& m, const std::vector<Field>& point_data,
                     const std::vector<Field>& cell_data) {
  Document doc;
  doc.head = fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<Points>\n",
      m.positions.size(), m.triangles.size());
  add_array<Vec3>(doc, "Points", "Float64", 3, m.positions);
  doc.head += "</Points>\n";
  add_polygons(doc, m);
  add_fields(doc, "PointData", point_data, m.positions.size());
  add_fields(doc, "CellData", cell_data, m.triangles.size());
  doc.head += "</Piece>\n";
  return doc;
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const TriangleMesh& m,
               const std::vector<Field>& point_data, const std::vector<Field>& cell_data) {
  const Document doc = document_of(m, point_data, cell_data);
  WholeFile file(path);
  file.stream() << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                   "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
                << doc.head << "</PolyData>\n<AppendedData encoding=\"raw\">\n_" << doc.appended
                << "\n</AppendedData>\n</VTKFile>\n";
  file.commit();
}

void write_pvd(const std::filesystem::path& path,
               const std::vector<std::pair<double, std::string>>& frames) {
  WholeFile file(path);
  file.stream() << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                   "<Collection>\n";
  for (const auto& [time, name] : frames)
    file.stream() << fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", time, name);
  file.stream() << "</Collection>\n</VTKFile>\n";
  file.commit();
}

}  // namespace tdbd::mesh
