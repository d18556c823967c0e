#include "bit/report/bit_output.hpp"

#include <nlohmann/json.hpp>

#include "bit/part_kind.hpp"
#include "bit/report/cone_report.hpp"
#include "io/whole_file.hpp"
#include "mesh/files/vtp.hpp"

namespace tdbd::bit {

nlohmann::ordered_json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

void write_bit_files(const std::filesystem::path& folder, const Bit& bit,
                     std::span<const PartLaw> laws) {
  nlohmann::ordered_json cutters = nlohmann::ordered_json::array();
  for (const Cutter& c : bit.cutters)
    cutters.push_back({{"name", "cutter-" + std::to_string(c.id)},
                       {"blade", c.blade},
                       {"zone", c.zone},
                       {"tip_radius_m", c.tip_radius},
                       {"azimuth_rad", c.azimuth},
                       {"tip_height_m", c.tip_height},
                       {"profile_angle_rad", c.profile_angle},
                       {"back_rake_rad", c.back_rake},
                       {"side_rake_rad", c.side_rake},
                       {"diameter_m", c.diameter},
                       {"chamfer_m", c.chamfer}});
  nlohmann::ordered_json file{
      {"schema", 1}, {"name", bit.name}, {"gage_radius_m", bit.gage_radius}, {"cutters", cutters}};
  if (!bit.cones.empty()) file["cones"] = cones_json(bit);
  file["parts"] = properties_json(bit, laws);
  write_text(folder / "bit.json", file.dump(2) + "\n");
}

mesh::TriangleMesh merged_mesh(const Bit& bit, const Pose& X_WB,
                               std::vector<int>* part_of_triangle) {
  mesh::TriangleMesh all;
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const Part& part = bit.parts[i];
    const int first = static_cast<int>(all.positions.size());
    for (const Vec3& x_P : part.mesh_P.positions) all.positions.push_back(X_WB * (part.X_BP * x_P));
    for (const mesh::Triangle& t : part.mesh_P.triangles) {
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      if (part_of_triangle) part_of_triangle->push_back(static_cast<int>(i));
    }
  }
  return all;
}

void write_bit_vtp(const std::filesystem::path& path, const Bit& bit, const Pose& X_WB) {
  std::vector<int> owner;
  const mesh::TriangleMesh all = merged_mesh(bit, X_WB, &owner);
  constexpr auto whole = mesh::FieldValues::whole_numbers;
  mesh::Field part{"part", {}, whole}, kind{"kind", {}, whole}, cutter{"cutter", {}, whole},
      cone{"cone", {}, whole};
  for (const int i : owner) {
    const Part& p = bit.parts[static_cast<std::size_t>(i)];
    part.values.push_back(i);
    kind.values.push_back(static_cast<double>(p.kind));
    cutter.values.push_back(p.cutter);
    cone.values.push_back(p.cone);
  }
  std::vector<mesh::Field> cells{part, kind, cutter};
  if (!bit.cones.empty()) cells.push_back(cone);
  mesh::write_vtp(path, all, {}, cells);
}

}  // namespace tdbd::bit
