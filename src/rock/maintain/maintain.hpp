#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "rock/maintain/intersections.hpp"
#include "rock/maintain/strays.hpp"
#include "rock/maintain/touched_region.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

enum class Smoothing { off, tangential };

/// Limits of the surface's shape. Lengths in m. Thesis: 4.2.4 (reconstructed: our excerpt has the
/// operations' names only); formulation 3.
struct MaintenanceLimits {
  double shortest_edge = 0.0;   ///< L_min: shorter edges collapse
  double longest_edge = 0.0;    ///< L_max: longer edges are bisected
  double worst_quality = 0.1;   ///< q_min: triangles below collapse their shortest edge
  double flip_quality = 0.0;    ///< triangles below may flip their edges; 0: no flips
  double smooth_quality = 0.0;  ///< vertices of triangles below are smoothed
  Smoothing smoothing = Smoothing::off;
  double volume_per_operation = 0.0;  ///< m3: no operation changes the volume by more
  double farthest = 0.0;  ///< m: nor moves the surface farther, all of a maintenance together (M6)
  double untangle_volume = 0.0;      ///< m3: the same of a collapse that parts what intersects
  double untangle_farthest = 0.0;    ///< m: and its distance; 0: intersections are not looked for
  double ridge_cut = 0.0;            ///< m: nor cuts more off a sharp ridge
  double least_normal_cosine = 0.3;  ///< nor turns a normal farther
  double steepest_overhang = 0.1;    ///< sine: an upright triangle may come to lean over so far
  double sharp_cosine = 0.7;         ///< of the normals beside an edge: below, it is a sharp ridge
  int most_rounds = 1000;            ///< of one kind of repair in one maintenance; more is an error
};

/// Limits that suit an edge length h: lengths in [0.4, 1.6] h, 0.01 h^3, half of L_min.
MaintenanceLimits limits_for(double edge_length);

/// What maintenance does to the surface: 4.2.2, 4.2.1, ours, 4.2.3, ours, ours.
enum class Operation { bisection, collapse, flip, smoothing, blunting, untangling, count };
inline constexpr std::array<const char*, static_cast<std::size_t>(Operation::count)>
    operation_names{"bisections", "collapses", "flips", "smoothings", "bluntings", "untanglings"};

inline const char* name_of(Operation o) { return operation_names[static_cast<std::size_t>(o)]; }

/// Why an operation was refused; counted, never silent.
enum class Refusal {
  boundary,
  topology,
  normal,
  overhang,
  too_long,
  too_short,
  quality,
  volume,
  distance,
  ridge,
  intersection,
  count
};
inline constexpr std::array<const char*, static_cast<std::size_t>(Refusal::count)> refusal_names{
    "boundary", "topology", "normal",   "overhang", "too_long",    "too_short",
    "quality",  "volume",   "distance", "ridge",    "intersection"};

struct MaintenanceReport {
  std::array<long, static_cast<std::size_t>(Operation::count)> done{};
  std::array<std::array<long, static_cast<std::size_t>(Refusal::count)>,
             static_cast<std::size_t>(Operation::count)>
      refused{};
  long touched_triangles = 0;     ///< looked at because rock was touched
  double volume_change = 0.0;     ///< m3 of hole gained, signed
  double volume_disturbed = 0.0;  ///< m3, sum of magnitudes

  long carried_out(Operation o) const { return done[static_cast<std::size_t>(o)]; }
};

/// Counts one operation that was carried out and the m3 of hole that it gained.
void note_done(MaintenanceReport& report, Operation what, double volume);

void note_refused(MaintenanceReport& report, Operation what, Refusal why);

/// Sum of all refusals.
long refusals(const MaintenanceReport& report);

/// Adds `more` to `sum`.
void add(const MaintenanceReport& more, MaintenanceReport& sum);

/// Name and count of every operation ("flips") and refusal ("refused_flips_normal").
std::vector<std::pair<std::string, long>> counts(const MaintenanceReport& report);

struct MaintenanceWorkspace {
  struct Candidate {
    double key;
    int a, b;
  };
  TouchedRegion touched;
  std::vector<int> ring, changed, region;
  std::vector<Candidate> edges;
  std::vector<int> seen;  ///< per triangle: the last visit's stamp
  int stamp = 0;
  Strays strays;              ///< of the last maintenance
  std::vector<int> suspects;  ///< triangles that may pass through others
  Patch patch;
  IntersectionWork intersections;
};

/// One maintenance of the region touched since the last: blunts spikes, bisects long edges (longest
/// first); then collapses short edges and bad triangles (shortest first) and flips edges of bad
/// triangles, in rounds until no repair is left; smooths vertices once and repairs what that made
/// necessary; parts what passes through itself (untangle.hpp). The boundary and what was not
/// touched stay bit for bit. Adds to `report`. Throws RunError with a place if repairs go on after
/// most_rounds. Thesis: 4.2.1 to 4.2.3.
void maintain(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
              MaintenanceReport& report);

}  // namespace tdbd::rock
