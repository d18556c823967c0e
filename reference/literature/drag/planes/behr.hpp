#pragma once

#include <vector>

#include "reference/literature/drag/drag_law.hpp"
#include "reference/literature/drag/plane/cutter_rim.hpp"
#include "reference/literature/drag/planes/bit_path.hpp"
#include "reference/literature/surface/spoke_plane.hpp"
#include "reference/literature/surface/spokes.hpp"

namespace tdbd::reference {

/// The model of Behr, Warren, Sinor and Brett (1991, SPE 21928). Thesis: 2.1, "radial planes at 5
/// [degree] intervals discretized in the radial direction ... can replicate whirl motion
/// kinematicly". Only that is known. Reconstructed: the whole step, as follows.
///
/// The bottom is one depth at each node of each plane (Spokes). When the tip of a cutter crosses a
/// plane, in either sense about the hole's axis, its rim is projected into that plane as an ellipse
/// (planar form) and lowers the nodes above it. The area A between outline and bottom counts as A
/// |v.e|/|v| (e: azimuth about the hole), with v horizontal: as in the single plane, the helix
/// carries no weight. Forces follow drag_law, the cutting force against v. A face that moves
/// backwards does not cut: its back rubs, with flat_force over A.

/// How long the force of a crossing counts. If the bit's centre does not move, the first two are
/// equal.
enum class ForceTime {
  held,     ///< until the cutter's next crossing
  spread,   ///< for the time to the next plane; what is left at the next crossing counts then
  crossing  ///< all of that time at once, in the step of the crossing
};

struct BehrOptions {
  int planes = 72;                   ///< 72 planes are 5 degrees apart
  int nodes = 500;                   ///< on each; the authors' number is not known
  double radius = 0.0;               ///< m, to which planes extend, > 0
  std::vector<double> normal_ratio;  ///< zeta of each cutter; empty: the rock's value for all
  std::vector<double> flat_area;     ///< Aw of each cutter, m2; empty: none. Only where it cuts
  ForceTime force_time = ForceTime::spread;
  double nearness = 5e-6;  ///< m, tolerance of straight segments on a path given by a function
};

/// What a cutter cut when it last crossed a plane. Its force keeps that value, constant in the
/// bit's frame.
struct BehrCut {
  double area = 0.0;            ///< m2, in the plane
  double effective = 0.0;       ///< m2, its projection normal to the velocity
  double arm = 0.0;             ///< m, of its centre from the hole's axis
  bool is_backward = false;     ///< the back of the face was ahead
  CutterForce force;            ///< N
  Vec3 force_B = Vec3::Zero();  ///< N, on the bit
  double torque = 0.0;          ///< N m, about the bit's axis
  double left = 0.0;            ///< s, for which the force still counts
};

/// A tip crosses a plane.
struct BehrCrossing {
  double when = 0.0;  ///< in [0, 1] of a sub-step
  std::size_t cutter = 0;
  int plane = 0;
  bool is_backward = false;  ///< against the hole's +azimuth
};

/// The bottom and the state of the cutters; one per bit.
struct BehrState {
  Spokes bottom;
  std::vector<SpokePlane> planes;
  BitPlace place;
  std::vector<CutterRim> rims;
  std::vector<double> azimuth;          ///< rad, of each tip about the hole's axis, unwrapped
  std::vector<BehrCut> last;            ///< of each cutter
  std::vector<double> since;            ///< s of the way whose force has been counted, per cutter
  std::vector<BehrCrossing> crossings;  ///< of the current sub-step, in order of time
};

/// Results for one cutter in one step.
struct BehrCutter {
  Vec3 force_W = Vec3::Zero();                ///< N, on the bit
  CutterForce force;                          ///< N, magnitudes of its two components
  double area = 0.0;                          ///< m2, sum over the step's crossings
  double volume = 0.0;                        ///< m3, removed in the step
  double rubbed_volume = 0.0;                 ///< m3, the part removed by the back of the face
  int crossings = 0, backward_crossings = 0;  ///< backward: against the hole's +azimuth
};

/// One step.
struct BehrLoad {
  double weight = 0.0, torque = 0.0;                    ///< N, N m about the bit's axis
  Eigen::Vector2d lateral_W = Eigen::Vector2d::Zero();  ///< N, on the bit
  double volume = 0.0;                                  ///< m3
  std::vector<BehrCutter> cutters;
};

/// Places the bit on a bottom that it has not cut: at each radius as deep as the deepest outline,
/// all around. Throws InputError that begins with "Behr et al.".
BehrState behr_start(const std::vector<bit::Cutter>& cutters, const BitPlace& place,
                     const BehrOptions& options);

/// Moves the bit straight to `to` in `dt` (s) and cuts. `load` keeps its arrays from step to step.
void behr_step(BehrState& state, const BitPlace& to, double dt, const DragRock& rock,
               const BehrOptions& options, BehrLoad& load);

/// Moves the bit along a path from time `from` (s), at which it is on the path, for `dt`. The path
/// is divided into segments short enough to follow a whirl of any frequency, independent of the
/// step size.
void behr_step(BehrState& state, const BitPath& path, double from, double dt, const DragRock& rock,
               const BehrOptions& options, BehrLoad& load);

/// A run: series over the steps, sums over the cutters.
struct BehrRun {
  double dt = 0.0;                         ///< s
  std::vector<double> weight, torque;      ///< N, N m, of each step
  std::vector<Eigen::Vector2d> lateral_W;  ///< N, of each step
  std::vector<double> volume;              ///< m3, of each step
  std::vector<BehrCutter> cutters;         ///< sums; forces: means of the steps

  /// Mean area over a cutter's crossings, m2.
  double mean_area(std::size_t cutter) const;
  double removed() const;         ///< m3
  double backward_share() const;  ///< over all crossings
};

/// Follows a path from time `from` (s) for `steps` steps, starting from the state, which must be on
/// the path at that time.
BehrRun behr_run(BehrState& state, const BitPath& path, double from, double dt, int steps,
                 const DragRock& rock, const BehrOptions& options);

/// Follows recorded places, dt apart; the first is that of the state.
BehrRun behr_run(BehrState& state, const std::vector<BitPlace>& places, double dt,
                 const DragRock& rock, const BehrOptions& options);

}  // namespace tdbd::reference
