#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The wear of a piece at the end of a run.
struct PieceWearFigures {
  std::string name;
  bool is_cutter = true;  ///< or a tooth or a gage pad
  bit::WearFlat flat;     ///< of run and table; its volume is that of the run
  double pending = 0.0;   ///< m3, worn since the last wear step and not yet cut from the mesh
  PieceRub rub;           ///< of the last step
};

/// The wear of a bit: `wear` of summary.json.
struct WearFigures {
  double acceleration = 1.0;
  double distance = 0.0;  ///< m of wear
  long steps = 0;         ///< wear steps
  double ledger_defect = 0.0;
  double mass_lost = 0.0;  ///< kg
  double worn = 0.0;       ///< m3, of all pieces
  double largest = 0.0;    ///< m3, of the piece that is worn most
  double unevenness =
      0.0;  ///< standard deviation of worn volumes over their mean, of the pieces that wore
  bit::DullGrade grade;
  std::vector<PieceWearFigures> pieces;
  std::vector<WearRecord> records;
};

/// The wear of a simulation of this case so far; its bit must wear.
WearFigures figures_of_wear(const Case& c, const Simulation& s);

nlohmann::ordered_json wear_json(const WearFigures& f);

}  // namespace tdbd::simulation
