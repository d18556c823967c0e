#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/config/field.hpp"
#include "mesh/measures.hpp"
#include "mesh/surface.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

enum class Smoothing { off, tangential };

/// How the rock's mesh is kept in shape.
struct MaintenanceOptions {
  long every = 5;
  long rest = 4;
  long longest_wait = 20;
  long renumber_every = 2500;
  double shortest_edge = 0.4;
  double longest_edge = 1.6;
  double worst_quality = 0.1;
  double flip_quality = 0.6;
  Smoothing smoothing = Smoothing::tangential;
  double smooth_quality = 0.5;

  static constexpr TableKey table{"maintenance", "how the rock's mesh is kept in shape"};
  void visit(FieldVisitor& v) {
    v(every, {.name = "every", .hi = 1'000'000, .meaning = "steps between maintenances; 0: never"});
    v(rest, {.name = "rest",
             .hi = 1'000'000,
             .meaning = "steps without a move of a vertex before it is maintained; 0: none"});
    v(longest_wait, {.name = "longest_wait",
                     .lo = 1,
                     .hi = 1'000'000,
                     .meaning = "steps after which a vertex is maintained in any case"});
    v(renumber_every,
      {.name = "renumber_every",
       .hi = 1'000'000'000,
       .meaning = "steps between renumberings of the mesh by place, for speed; 0: never"});
    v(shortest_edge, {.name = "shortest_edge",
                      .range = Range::within(0.0, 0.7),
                      .meaning = "over rock.edge_length; shorter edges collapse"});
    v(longest_edge, {.name = "longest_edge",
                     .range = Range::within(1.3, 100.0),
                     .meaning = "over rock.edge_length; longer edges are split"});
    v(worst_quality, {.name = "worst_quality",
                      .range = Range::within(0.0, 0.5),
                      .meaning = "an operation makes no triangle worse than this"});
    v(flip_quality, {.name = "flip_quality",
                     .range = Range::within(0.0, 1.0),
                     .meaning = "triangles below may flip their longest edge; 0: none does"});
    v(smoothing, {.name = "smoothing",
                  .values = {{{"off", Smoothing::off}, {"tangential", Smoothing::tangential}}},
                  .meaning = "whether vertices move along the surface to better places"});
    v(smooth_quality, {.name = "smooth_quality",
                       .range = Range::within(0.0, 1.0),
                       .meaning = "vertices of triangles below are smoothed"});
  }
};

/// Limits of the surface's shape. Lengths in m. Thesis: 4.2.4 (reconstructed: our excerpt has only
/// the names of the operations); rock (15) to (18).
struct MaintenanceLimits {
  double shortest_edge = 0.0;   ///< L_min: shorter edges collapse
  double longest_edge = 0.0;    ///< L_max: longer edges are bisected
  double worst_quality = 0.0;   ///< q_min: the shortest edge of a worse triangle collapses
  double flip_quality = 0.0;    ///< edges of worse triangles may flip; 0: no flips
  double smooth_quality = 0.0;  ///< vertices of worse triangles are smoothed
  Smoothing smoothing = Smoothing::off;
  double volume_per_operation = 0.0;  ///< m3: largest change of volume by one operation
  double farthest = 0.0;              ///< m: largest drift of the surface in one maintenance (M6)
  double untangle_volume = 0.0;       ///< m3: volume_per_operation for untangling collapses
  double untangle_farthest = 0.0;     ///< m: farthest for untangling collapses; 0: no untangling
  double ridge_cut = 0.0;             ///< m: deepest cut off a sharp ridge
  double least_normal_cosine = 0.3;   ///< cosine of the largest angle by which a normal may turn
  double steepest_overhang = 0.1;     ///< sine of an upright triangle's largest overhang
  double sharp_cosine = 0.7;  ///< an edge is a sharp ridge if the cosine of its normals is smaller
  int rest = 0;               ///< cuts without a move of a vertex before it is maintained
  int longest_wait = 0;       ///< cuts after which a vertex is maintained in any case
  int most_rounds = 1000;     ///< of one kind of repair in one maintenance; more is an error
};

/// Sets L_min and the distances derived from it: just below L_min / 2 and, for untangling, 2 L_min.
void set_shortest_edge(MaintenanceLimits& limits, double shortest);

/// Suitable limits for an edge length h: edges in [0.4, 1.6] h by default, volume 0.01 h^3, drift
/// L_min / 2.
MaintenanceLimits limits_for(double edge_length, const MaintenanceOptions& options = {});

/// Operations of maintenance. Thesis: bisection 4.2.2, collapse 4.2.1, smoothing 4.2.3; the others
/// are not in the thesis.
enum class Operation { bisection, collapse, flip, smoothing, blunting, untangling, count };
inline constexpr std::array<const char*, static_cast<std::size_t>(Operation::count)>
    operation_names{"bisections", "collapses", "flips", "smoothings", "bluntings", "untanglings"};

inline const char* name_of(Operation o) { return operation_names[static_cast<std::size_t>(o)]; }

/// Why an operation was refused. Every refusal is counted.
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

/// Counts of one or more maintenances.
struct MaintenanceReport {
  std::array<long, static_cast<std::size_t>(Operation::count)> done{};
  std::array<std::array<long, static_cast<std::size_t>(Refusal::count)>,
             static_cast<std::size_t>(Operation::count)>
      refused{};
  long touched_triangles = 0;     ///< examined because one of their vertices was touched
  double volume_change = 0.0;     ///< m3 of hole gained, signed
  double volume_disturbed = 0.0;  ///< m3, sum of magnitudes

  long carried_out(Operation o) const { return done[static_cast<std::size_t>(o)]; }

  template <class Archive>
  void serialize(Archive& a) {
    a(done, refused, touched_triangles, volume_change, volume_disturbed);
  }
};

/// Counts an operation that was carried out and its change of the hole's volume, m3.
void count_done(MaintenanceReport& report, Operation what, double volume);

/// Counts one refused operation.
void count_refused(MaintenanceReport& report, Operation what, Refusal why);

/// Sum of all refusals.
long refusals(const MaintenanceReport& report);

/// Adds `more` to `sum`.
void add(const MaintenanceReport& more, MaintenanceReport& sum);

/// Names and counts of every operation ("flips") and refusal ("refused_flips_normal").
std::vector<std::pair<std::string, long>> counts(const MaintenanceReport& report);

/// @file
/// Measures and guards of the triangles around a vertex, shared by the operations of maintenance.
/// Thesis: 4.2 (reconstructed).

/// The triangle of corner c, with the vertex of c first.
inline mesh::Facet facet_at(const mesh::Surface& s, int c) {
  return {s.position(s.vertex(c)), s.position(s.vertex(mesh::next_corner(c))),
          s.position(s.vertex(mesh::previous_corner(c)))};
}

inline double quality(const mesh::Facet& f) { return mesh::triangle_quality(f.a, f.b, f.c); }
inline Vec3 doubled_area(const mesh::Facet& f) { return (f.b - f.a).cross(f.c - f.a); }
inline Vec3 area_vector(const mesh::Facet& f) { return mesh::area_vector(f.a, f.b, f.c); }

/// The worst quality of the triangles at v.
double worst_quality(const mesh::Surface& s, int v);

/// Refuses a normal that turns by more than the limit, and a triangle that would overhang. Rock
/// that is moved straight down is a height field; this guard keeps it one, except for upright
/// walls. A triangle within `steepest_overhang` of upright may overhang by that much, as the facets
/// of a round core's wall do by their shape.
std::optional<Refusal> judge_turn(const Vec3& before, const Vec3& after,
                                  const MaintenanceLimits& limits);

/// Whether the triangles beside the edge that faces c meet at a sharp ridge or valley.
bool is_sharp(const mesh::Surface& s, int c, const MaintenanceLimits& limits);

/// Whether a sharp edge ends at v.
bool is_on_ridge(const mesh::Surface& s, int v, const MaintenanceLimits& limits);

/// Whether triangle t overhangs and is turned by more than 90 degrees against a triangle at one of
/// its corners. Layers of rock may pass through each other there.
bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t);

/// Upper bound, per vertex, m, of the distance by which the operations of one maintenance have
/// moved the surface. No point of a triangle is farther from the surface before the maintenance
/// than the largest value of its vertices (M6, rock (18)). An operation adds its own distance to
/// the largest value around it.
class SurfaceDrift {
 public:
  double of(int v) const { return at(v) < by_vertex_.size() ? by_vertex_[at(v)] : 0.0; }

  /// Raises the value of v to at least `distance`.
  void note(int v, double distance);

  void clear();

 private:
  std::vector<double> by_vertex_;
  std::vector<int> listed_;
};

/// The largest drift at v and its neighbours, m.
double largest_drift_around(const mesh::Surface& s, int v, const SurfaceDrift& drift);

/// Result of the guards on an operation. Computing it changes nothing.
struct Verdict {
  std::optional<Refusal> refused;  ///< the first reason; empty: accepted
  double volume = 0.0;             ///< m3 of hole gained
  double drift = 0.0;  ///< m, from the surface before the maintenance, after the operation
};

/// Moves v to x_W if the verdict accepts it, and counts the operation or its refusal. Returns
/// whether v was moved. Debug builds check the surface's promises around v.
bool move_if_accepted(Rock& rock, int v, const Vec3& x_W, Operation what, const Verdict& verdict,
                      SurfaceDrift& drift, MaintenanceReport& report);

}  // namespace tdbd::rock
