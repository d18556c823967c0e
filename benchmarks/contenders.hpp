#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::bench {

enum class StepKind { plain, maintained };

/// What a contender's mesh has become.
struct MeshFigures {
  long triangles = 0;
  double least_quality = 0.0, one_percent_quality = 0.0;  ///< mesh::QualityFigures
  long maintained = 0;  ///< triangles that maintenances have seen so far, one by one
};

/// One side of a comparison: something that drills step by step.
struct Contender {
  std::string name, what;
  std::function<StepKind()> step;
  std::function<MeshFigures()> mesh;  ///< none: it has no mesh
};

/// The height field that all are compared with.
inline constexpr const char* yardstick = "z-map-0.5";

/// All workloads of ours, height fields and spokes after their first revolution, or those that are
/// named and the yardstick. `settings`: KEY=VALUE of every case of ours. InputError: a name that
/// nothing has.
std::vector<Contender> contenders(const std::vector<std::string>& names,
                                  const std::vector<std::string>& settings);

}  // namespace tdbd::bench
