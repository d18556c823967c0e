#pragma once

#include <array>
#include <string>
#include <vector>

namespace tdbd::claims {

/// A mesh of bit A's cutters.
struct CutterMesh {
  const char* name;
  const char* bit;  ///< of cases/bits
};

/// Graded as bits B and C, even as the dissertation's bit A, and twice as coarse.
inline constexpr std::array<CutterMesh, 3> cutter_meshes = {
    {{"graded", "bit-a-graded"}, {"even 2 mm", "bit-a"}, {"even 4 mm", "bit-a-coarse"}}};

/// Where forces on faces come from: what they removed, or the section of rock ahead of them.
inline constexpr std::array<const char*, 2> cuts = {"volume", "section"};

/// Of the rock, from coarse to fine, m.
inline constexpr std::array<double, 5> rock_edges = {4e-3, 2.8e-3, 2e-3, 1.4e-3, 1e-3};

/// A run and its torque in every step after the start.
struct TorqueRun {
  std::size_t mesh = 0, cut = 0;
  double edge = 0.0;           ///< m, of the rock
  std::vector<double> torque;  ///< N m
};

double mean(const TorqueRun& run);

/// Root mean square about the mean, over the mean.
double noise(const TorqueRun& run);

/// Root mean square of the change from step to step, over the mean: what rings slowly does not count. Of noise that is
/// white it is sqrt(2) times `noise`.
double step_noise(const TorqueRun& run);

/// Bit A at a given rate at 3000 psi, the second revolution: each mesh, each way of cutting, each edge. Made once.
const std::vector<TorqueRun>& steady_runs();

/// The same with `maintenance.rest` = 0 (default 4): graded cutters and volumes alone, each edge. Made once.
const std::vector<TorqueRun>& runs_without_rest();

/// The same bit on a laboratory's simulator, moved by forces, its second second; edges of 2 mm. Made once.
const std::vector<TorqueRun>& drilling_runs();

const TorqueRun& run_of(const std::vector<TorqueRun>& runs, std::size_t mesh, std::size_t cut,
                        double edge);

}  // namespace tdbd::claims
