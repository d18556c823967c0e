#include "bit/files/part_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bit/bit.hpp"
#include "bit/files/mesh_keys.hpp"
#include "mesh/repair/repair.hpp"

namespace tdbd::bit {

bool is_part_name(const std::string& name) {
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '/';
  };
  return !name.empty() && name.front() != '/' && name.back() != '/' &&
         name.find("//") == std::string::npos && std::all_of(name.begin(), name.end(), is_word);
}

Vec3 read_direction(Config& c, const Vec3& fallback) {
  const Vec3 u = c.read(part_file_keys::update_direction, fallback);
  if (u.y() == 0.0 && u.norm() > 0.0) return u.normalized();
  c.problem(part_file_keys::update_direction, fmt::format("({}, {}, {})", u.x(), u.y(), u.z()),
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

}  // namespace tdbd::bit
