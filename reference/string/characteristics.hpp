#pragma once

#include <vector>

/// Slow twin of one wave type of src/string/chain: d'Alembert's characteristics.
namespace tdbd::reference {

/// A rod of cells that waves cross in one time step each: torsion (angles, N m s/rad) or axial motion
/// (displacements, N s/m). Cell k has an impedance; node k lies above cell k.
struct WaveRod {
  std::vector<double> impedance;  ///< of cells, downward
  double step = 0.0;              ///< s, in which a wave crosses a cell
  double end_inertia = 0.0;       ///< of a body at the lower end; 0: none
  double resting = 0.0;           ///< Coulomb's level at the lower end at rest
  double sliding = 0.0;           ///< and in motion
};

/// Speeds and waves of all nodes.
struct WaveState {
  std::vector<double> down, up;  ///< waves of speed that enter each cell from above and below
  double end_speed = 0.0;        ///< of the body at the lower end
  double time = 0.0;             ///< s
};

/// A rod that turns with one speed under a uniform load that its end bears.
WaveState uniform_waves(const WaveRod& rod, double speed, double load);

/// One time step with this speed of the top after it. At the lower end the body's equation is solved
/// exactly over the step, for a wave that is constant in it.
void advance_waves(const WaveRod& rod, double top_speed, WaveState& state);

/// Speed of a node and load of the cell below it.
double node_speed(const WaveState& state, int node);
double cell_load(const WaveRod& rod, const WaveState& state, int cell);

}  // namespace tdbd::reference
