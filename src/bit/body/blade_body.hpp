#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/body/blade_shape.hpp"

namespace tdbd::bit {

/// The part bit-body with blades and junk slots, in the bit frame: a closed, outward-oriented
/// manifold mesh whose vertices lie on the smooth body of `blade_shape`, with the gage section and
/// the shank above it. Vertices follow the edges of blades and slots, so volumes approach the
/// smooth body's with the square of options.edge. The body overlaps the cutters: pockets are not
/// cut out. Call blade_problems first. Thesis: 3.1; the form is ours.
Part blade_body(const std::vector<Cutter>& cutters, const BladeOptions& options,
                double gage_radius);

/// Free area (m2) between the hole's wall and the body across the lower gage: the junk slots. Exact
/// for the mesh's polygon.
double junk_slot_area(const BladeShape& shape, const BladeOptions& options, double gage_radius);

/// A mistake of the blades: the key, what was found where, what would be right.
struct BladeProblem {
  std::string key, found, expected;
};

/// Why there is no such body: an exposure that lifts a cutter off its blade or buries its tip;
/// slots deeper than the profile's curvature allows, or so deep that they leave no core; blades too
/// narrow for their cutters, that cross, or that close the slot between them at the gage.
std::vector<BladeProblem> blade_problems(const std::vector<Cutter>& cutters,
                                         const BladeOptions& options, double gage_radius);

}  // namespace tdbd::bit
