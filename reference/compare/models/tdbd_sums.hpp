#pragma once

#include <vector>

#include "reference/compare/compare_case.hpp"
#include "reference/compare/findings.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::reference {

/// A unit of the report: a cutter with all its parts, a tooth, a row of teeth, or a cone.
struct Piece {
  std::string name;
  double radius = 0.0;  ///< m: of a cutter's tip, or of the ring that a row prints; 0 for a cone
  int whole = -1;       ///< index of the containing piece (row of a tooth, cone of a row), or -1
  double area = 0.0;    ///< m2, sum over steps
  double normal = 0.0, drag = 0.0, weight = 0.0;  ///< N, sums over steps
  double weight_now = 0.0, largest_weight = 0.0;  ///< N, of the last step and of all steps
  long contacts = 0;                              ///< teeth that touched rock, sum over steps
};

/// Sums over the counted steps of a run.
struct TdbdSums {
  std::vector<Piece> pieces;
  std::vector<int> piece_of_part;  ///< index of the smallest piece that contains the part; -1: none
  LoadSeries series;
  Eigen::Vector2d lateral_B = Eigen::Vector2d::Zero();  ///< N, sum of lateral forces, bit frame
  double side = 0.0;                                    ///< N, sum of their magnitudes
  std::vector<double> teeth;                            ///< number in contact, per step
  double squares = 0.0;  ///< m2, of the bit's distance from the hole's axis
  long backwards = 0;    ///< number of cutters that move backwards
};

TdbdSums start_sums(const simulation::Case& c);

/// Adds the last step of the run.
void add_step(const simulation::Case& c, const simulation::Simulation& s, TdbdSums& sums);

/// Rock that each piece has removed since the start of the run, m3.
std::vector<double> removed_by_piece(const TdbdSums& sums, const simulation::Simulation& s);

/// Sets the results of the pieces: means over the steps. `volumes`: m3 per revolution, per piece.
void set_piece_quantities(const simulation::Case& c, const TdbdSums& sums,
                          const std::vector<double>& volumes, Findings& f);

}  // namespace tdbd::reference
