#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::bench {

enum class StepKind { plain, maintained };

/// Properties of a contender's mesh.
struct MeshFigures {
  long triangles = 0;
  double least_quality = 0.0, one_percent_quality = 0.0;  ///< mesh::QualityStatistics
  long maintained = 0;  ///< number of triangles processed by all maintenances so far
};

/// One side of a comparison: a program that drills step by step.
struct Contender {
  std::string name, what;
  std::function<StepKind()> step;
  std::function<MeshFigures()> mesh;  ///< empty: it has no mesh
};

/// The height field with which all others are compared.
inline constexpr const char* yardstick = "z-map-0.5";

/// Returns all TDBD workloads, height fields and spokes after their first revolution, or only those
/// that are named and the yardstick. `settings`: KEY=VALUE for every TDBD case. Throws InputError
/// for an unknown name.
std::vector<Contender> contenders(const std::vector<std::string>& names,
                                  const std::vector<std::string>& settings);

}  // namespace tdbd::bench
