#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/body/blade_shape.hpp"

namespace tdbd::bit {

/// Makes the part bit-body with blades and junk slots, in the bit frame: a closed, outward-oriented
/// manifold mesh whose vertices lie on the smooth body of `blade_shape`, with the gage section and
/// the shank above it. Vertices follow the edges of blades and slots, so volumes converge to those
/// of the smooth body with the square of options.edge. The body overlaps the cutters, because
/// pockets are not cut out. Call blade_problems first. Thesis: 3.1; the shape is not in the thesis.
Part blade_body(const std::vector<Cutter>& cutters, const BladeOptions& options,
                double gage_radius);

/// Free area (m2) between the wall of the hole and the body across the lower gage: the junk slots.
/// Exact for the mesh's polygon.
double junk_slot_area(const BladeShape& shape, const BladeOptions& options, double gage_radius);

/// A mistake of the blades: the key, what was found and where, and what is expected.
struct BladeProblem {
  std::string key, found, expected;
};

/// Returns the reasons why such a body cannot be made: an exposure that lifts a cutter off its
/// blade or buries its tip; slots deeper than the profile's curvature allows, or so deep that they
/// leave no core; blades that are too narrow for their cutters, that cross, or that close the slot
/// between them at the gage.
std::vector<BladeProblem> blade_problems(const std::vector<Cutter>& cutters,
                                         const BladeOptions& options, double gage_radius);

}  // namespace tdbd::bit
