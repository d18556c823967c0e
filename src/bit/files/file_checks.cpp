#include "bit/files/file_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bit/files/bit_parts.hpp"
#include "bit/files/pdc_file.hpp"
#include "mesh/files/length_unit.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair.hpp"

namespace tdbd::bit {
namespace {

constexpr const char* unit_wanted = "a unit that fits (unit_check = \"off\" admits any size)";

double across(const std::vector<Part>& parts) {
  double radius = 0.0;
  for (const Part& part : parts)
    for (const Vec3& x_P : part.mesh_P.positions)
      radius = std::max(radius, (part.X_BP * x_P).head<2>().norm());
  return 2.0 * radius;
}

}  // namespace

bool is_part_name(const std::string& name) {
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '/';
  };
  return !name.empty() && name.front() != '/' && name.back() != '/' &&
         name.find("//") == std::string::npos && std::all_of(name.begin(), name.end(), is_word);
}

Vec3 read_direction(Config& c, const Vec3& fallback) {
  PartDirection s{fallback};
  read_fields(c, s);
  const Vec3& u = s.update_direction;
  if (u.y() == 0.0 && u.norm() > 0.0) return u.normalized();
  c.problem("update_direction", fmt::format("({}, {}, {})", u.x(), u.y(), u.z()),
            "a direction at azimuth 0, (x, 0, z)");
  return Vec3::UnitZ();
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

void report_mesh_faults(Config& c, const std::string& key, const std::string& file,
                        const std::vector<mesh::Solid>& solids, const std::string& expected) {
  const std::vector<std::string> lines = mesh::mesh_faults(file, solids);
  if (lines.empty()) return;
  c.problem(key, file + ", which bounds no solid", expected);
  for (const std::string& line : lines) c.other_file(line);
}

bool contradicts_unit(Config& c, const std::string& file, double unit) {
  const std::string found = mesh::unit_contradiction(file, unit);
  if (!found.empty()) c.problem("unit", found, "the unit that the file states, or no unit");
  return !found.empty();
}

std::string unit_question(double size, double unit, const SizeRange& usual) {
  if (size >= usual.least && size <= usual.most) return "";
  constexpr std::pair<const char*, double> units[] = {
      {"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"m", 1.0}};
  std::string guesses;
  for (const auto& [name, metres] : units)
    if (const double other = size / unit * metres; other >= usual.least && other <= usual.most)
      guesses += fmt::format("{}in {} (unit = \"1 {}\": {:.6g} mm)", guesses.empty() ? "" : ", ",
                             name, name, 1e3 * other);
  return fmt::format("a size of {:.6g} mm, where {} has {:.6g} to {:.6g} mm: {}", 1e3 * size,
                     usual.thing, 1e3 * usual.least, 1e3 * usual.most,
                     guesses.empty() ? "in what unit is it?" : "is it " + guesses + "?");
}

bool unit_check_enabled(Config& c) {
  UnitCheck s;
  read_fields(c, s);
  return s.unit_check;
}

void unit_error(Config& c, const std::string& key, const std::vector<Part>& parts, double unit) {
  if (parts.empty()) return;
  const std::string question = unit_question(across(parts), unit, bit_across);
  if (!question.empty()) c.problem(key, question, unit_wanted);
}

void unit_error(Config& c, const std::string& key, const mesh::TriangleMesh& m, double unit,
                const SizeRange& usual) {
  if (m.triangles.empty()) return;
  const std::string question = unit_question(mesh::bounding_box(m).size().maxCoeff(), unit, usual);
  if (!question.empty()) c.problem(key, question, unit_wanted);
}

}  // namespace tdbd::bit
