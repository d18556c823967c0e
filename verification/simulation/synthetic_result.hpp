#pragma once

#include <cmath>
#include <fstream>

#include "io/output_folder.hpp"
#include "io/whole_file.hpp"
#include "mesh/files/vtp.hpp"
#include "simulation/result/summary.hpp"

namespace tdbd::simulation {

/// A round hole with concentric grooves, as 8 cutters on a 4.25 in radius would leave it; m, z
/// down.
inline mesh::TriangleMesh grooved_hole(int rings, int spokes) {
  constexpr double pi = 3.14159265358979323846, radius = 0.108;
  mesh::TriangleMesh m;
  m.positions.push_back(Vec3(0, 0, 0.0));
  for (int i = 1; i <= rings; ++i)
    for (int j = 0; j < spokes; ++j) {
      const double s = static_cast<double>(i) / rings, phi = 2.0 * pi * j / spokes;
      const double wall = std::max(0.0, s - 0.95) * 1.2, r = radius * std::min(s, 0.95);
      const double groove = 0.0012 * std::abs(std::sin(8.0 * pi * s - 0.4 * std::sin(5 * phi)));
      const double bowl = 0.02 * std::sin(1.5 * pi * s);
      m.positions.push_back(Vec3((r + 0.01 * wall) * std::cos(phi),
                                 (r + 0.01 * wall) * std::sin(phi), bowl + groove - wall));
    }
  const auto at = [&](int i, int j) { return i == 0 ? 0 : 1 + (i - 1) * spokes + j % spokes; };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < spokes; ++j) {
      m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      if (i > 0) m.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  return m;
}

/// A summary with 24 cutters whose volumes were made up.
inline RunSummary made_up_summary() {
  RunSummary s;
  s.command = "run";
  s.title = "synthetic hole";
  s.case_hash = "0123456789abcdef";
  s.steps = 720;
  s.revolutions = 2.0;
  s.duration = 1.0;
  for (int k = 1; k <= 24; ++k) {
    const double v = 1e-9 * k * (300.0 + 20.0 * (k % 3));
    for (const char* part : {"face", "chamfer"})
      s.parts.push_back({"cutter-" + std::to_string(k) + "/" + part, 2 * v, {v, v}});
    s.removed_volume += 4 * v;
  }
  s.removed_volume_by_revolution = {0.5 * s.removed_volume, 0.5 * s.removed_volume};
  return s;
}

/// The 24 cutters' radii and zones, as a run writes them.
inline void write_bit_json(const std::filesystem::path& path) {
  const char* zones[] = {"cone", "nose", "shoulder", "gage"};
  std::ofstream out(path);
  out << "{\"cutters\":[";
  for (int k = 1; k <= 24; ++k)
    out << (k > 1 ? "," : "") << "{\"name\":\"cutter-" << k
        << "\",\"tip_radius_m\":" << 0.108 * std::min(1.0, k / 22.0) << ",\"blade\":" << 1 + k % 5
        << ",\"zone\":\"" << zones[std::min(3, (k - 1) / 6)] << "\"}";
  out << "]}\n";
}

/// A small result folder as a run would leave it.
inline OutputFolder write_synthetic_result(const std::filesystem::path& path, int rings,
                                           int spokes) {
  const OutputFolder folder = prepare(path, Overwrite::force);
  mesh::write_vtp(folder.frames() / "rock_final.vtp", grooved_hole(rings, spokes), {}, {});
  write_text(folder.summary(), to_json(made_up_summary()));
  write_bit_json(folder.path / "bit.json");
  return folder;
}

}  // namespace tdbd::simulation
