#pragma once

#include "rock/maintain.hpp"

namespace tdbd::rock {

/// Collapses the edge (a, b) to whichever of its ends or midpoint changes the volume least, if
/// every guard agrees: boundary, topology (fig. 4.18), no normal turned too far, no edge too long,
/// no triangle worse than what was there and than the limit, volume within the bound. Counts the
/// first refusal's reason. Thesis: 4.2.1.
void try_collapse(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                  MaintenanceReport& report);

}  // namespace tdbd::rock
