#include <fmt/format.h>

#include <string>
#include <vector>

#include "claims/spoke_runs.hpp"

/// Errors of both kinds of spokes and of our mesh after one revolution of the standard workload,
/// steady and in whirl, at equal numbers of points: reports/studies/spokes. No arguments;
/// some minutes.
namespace tdbd::claims {
namespace {

constexpr double mm = 1e-3, edge_length = 1.4 * mm, fine_cell = 0.2 * mm;
const std::vector<double> rings{2 * mm,  20 * mm, 40 * mm,  60 * mm,
                                80 * mm, 90 * mm, 100 * mm, 106 * mm};

void print_rings(const SpokeErrors& e) {
  for (std::size_t i = 0; i < e.mesh.size(); ++i)
    fmt::print("  r {:5.1f}: {:.4f} {:.4f} {:.4f}; p95 {:.3f} {:.3f} {:.3f}\n",
               0.5 * (e.mesh[i].r_lo + e.mesh[i].r_hi) / mm, e.langeveld[i].mean / mm,
               e.hanson[i].mean / mm, e.mesh[i].mean / mm, e.langeveld[i].p95 / mm,
               e.hanson[i].p95 / mm, e.mesh[i].p95 / mm);
}

void study(const std::string& motion, const std::vector<std::string>& settings) {
  for (const int spokes : {60, 120, 240, 480}) {
    const SpokeDrilling d = drill_spokes(spoke_plan(edge_length, settings), spokes, fine_cell);
    const SpokeErrors all = spoke_errors(d, {rings.front(), rings.back()});
    fmt::print(
        "{}, {} spokes: nodes of Langeveld {}, of Hanson and Hansen {}, points of the mesh "
        "{}\n",
        motion, spokes, d.langeveld.depth.size(), nodes_inside(d.hanson, d.plan.bit),
        points_within(d.mesh_W, 0.0, d.plan.bit.gage_radius - 0.1 * mm));
    fmt::print("mean error, mm: Langeveld, Hanson and Hansen, mesh\n");
    print_rings(all);
    print_rings(spoke_errors(d, rings));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace tdbd::claims

int main() {
  tdbd::claims::study("steady", {});
  tdbd::claims::study("whirl", tdbd::claims::spoke_whirl());
}
