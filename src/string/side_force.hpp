#pragma once

#include <vector>

#include "string/section.hpp"

namespace tdbd::string {

/// Coulomb friction coefficients below a measured depth.
struct FrictionBelow {
  double depth = 0.0;  ///< m
  double resting = 0.0, sliding = 0.0;
};

/// Contact of a string with its hole: for each of n + 1 nodes the weight along the hole (N) and the
/// data for its friction. The side force (N) of a node is a sum over its pieces, which the tension
/// T of their element presses against the wall (string (4)):
///   N = sum sqrt((a T + 2 b) T + c)
/// The end nodes have no friction: their pieces belong to the adjacent nodes, which is an error of
/// second order in the element length.
struct Contact {
  std::vector<double> weight;            ///< along the hole, of n + 1 cells, N
  std::vector<double> radius;            ///< radius at which the node touches the hole, m
  std::vector<double> resting, sliding;  ///< Coulomb friction coefficients
  std::vector<double> a, b, c;           ///< of the pieces: 1, N, N2
  std::vector<int> element, node;        ///< of the pieces, in downward order
};

/// Divides the string at nodes, centres of elements, ends of sections, stations of the survey and
/// depths at which friction changes. `friction` is ordered by depth, downward; its first entry
/// starts at the top. Empty: no friction.
Contact make_contact(const std::vector<Section>& sections, const Survey& survey,
                     const std::vector<FrictionBelow>& friction, int elements);

/// Computes the side forces of all nodes, N, from the tensions of all elements, N. Allocates
/// nothing if `side_force` already has one entry per node.
void side_forces(const Contact& contact, const std::vector<double>& tension,
                 std::vector<double>& side_force);

/// Side force of one node, N, for the given tensions of its adjacent elements, N.
double side_force_at(const Contact& contact, int node, double above, double below);

}  // namespace tdbd::string
