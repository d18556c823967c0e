#pragma once

#include <array>
#include <vector>

#include "rock/rock.hpp"

namespace tdbd::rock {

/// Limits of the surface's shape. Lengths in m. Thesis: 4.2.4 (reconstructed: our excerpt has the
/// operations' names only); formulation 3.
struct MaintenanceLimits {
  double shortest_edge = 0.0;        ///< L_min: shorter edges collapse
  double longest_edge = 0.0;         ///< L_max: longer edges are bisected
  double worst_quality = 0.1;        ///< triangles below collapse their shortest edge
  double volume_per_collapse = 0.0;  ///< m3: a collapse may not change the volume by more
  double least_normal_cosine = 0.3;  ///< a collapse may not turn a normal farther
};

/// Limits that suit an edge length: [0.4, 1.6] h, 0.01 h^3.
MaintenanceLimits limits_for(double edge_length);

/// Why an operation was refused; counted, never silent.
enum class Refusal { boundary, topology, normal, overhang, too_long, quality, volume, count };
inline constexpr std::array<const char*, static_cast<std::size_t>(Refusal::count)> refusal_names{
    "boundary", "topology", "normal", "overhang", "too_long", "quality", "volume"};

struct MaintenanceReport {
  long bisections = 0;
  long collapses = 0;
  std::array<long, static_cast<std::size_t>(Refusal::count)> refused{};
  double volume_change = 0.0;     ///< m3 of hole gained, signed
  double volume_disturbed = 0.0;  ///< m3, sum of magnitudes
};

struct MaintenanceWorkspace {
  struct Candidate {
    double key;
    int a, b;
  };
  std::vector<int> ring, changed;
  std::vector<Candidate> edges;
};

/// One maintenance of the region touched since the last: bisects long edges (longest first), then
/// collapses short edges and bad triangles (shortest first) until no repair is left. The boundary
/// and what was not touched stay bit for bit. Adds to `report`. Thesis: 4.2.1, 4.2.2.
void maintain(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
              MaintenanceReport& report);

}  // namespace tdbd::rock
