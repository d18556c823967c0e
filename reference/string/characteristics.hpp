#pragma once

#include <vector>

/// Slow twin of one wave type of src/string/chain: d'Alembert's method of characteristics.
namespace tdbd::reference {

/// A rod of cells that waves cross in exactly one time step: torsion (angles, N m s/rad) or axial
/// motion (displacements, N s/m). Each cell has an impedance; node k is above cell k.
struct WaveRod {
  std::vector<double> impedance;  ///< of cells, downward
  double step = 0.0;              ///< s, time in which a wave crosses a cell
  double end_inertia = 0.0;       ///< of a body at the lower end; 0: none
  double resting = 0.0;           ///< Coulomb friction at the lower end at rest
  double sliding = 0.0;           ///< and in motion
};

/// Speeds and waves of all nodes.
struct WaveState {
  std::vector<double> down, up;  ///< velocity waves that enter each cell from above and below
  double end_speed = 0.0;        ///< of the body at the lower end
  double time = 0.0;             ///< s
};

/// A rod that rotates uniformly under a uniform load, which its end supports.
WaveState uniform_waves(const WaveRod& rod, double speed, double load);

/// Makes one time step; `top_speed` is the speed of the top at its end. The equation of the body at
/// the lower end is solved exactly over the step, for a wave that is constant in it.
void advance_waves(const WaveRod& rod, double top_speed, WaveState& state);

/// Speed of a node and load of the cell below it.
double node_speed(const WaveState& state, int node);
double cell_load(const WaveRod& rod, const WaveState& state, int cell);

}  // namespace tdbd::reference
