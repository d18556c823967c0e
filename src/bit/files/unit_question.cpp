#include "bit/files/unit_question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bit/files/pdc_keys.hpp"
#include "mesh/measures.hpp"

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

bool unit_check_enabled(Config& c) { return c.read(bit_file_keys::unit_check); }

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
