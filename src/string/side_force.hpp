#pragma once

#include <vector>

#include "string/section.hpp"
#include "string/survey.hpp"

namespace tdbd::string {

/// Coulomb's coefficients below a measured depth.
struct FrictionBelow {
  double depth = 0.0;  ///< m
  double resting = 0.0, sliding = 0.0;
};

/// How a string lies in its hole: for each of n + 1 nodes the weight along the hole (N) and what its
/// friction needs. The side force (N) of a node is a sum over its pieces, which the tension T of
/// their element presses against the wall (string (4)):
///     N = sum sqrt((a T + 2 b) T + c)
/// Both ends have no friction of their own: their pieces belong to the nodes beside them, an error
/// of second order in the element length.
struct Contact {
  std::vector<double> weight;            ///< along the hole, of n + 1 cells, N
  std::vector<double> radius;            ///< where the node touches the hole, m
  std::vector<double> resting, sliding;  ///< Coulomb's coefficients
  std::vector<double> a, b, c;           ///< of the pieces: 1, N, N2
  std::vector<int> element, node;        ///< of the pieces, downward
};

/// Cuts the string at nodes, middles of elements, ends of sections, stations of the survey and
/// depths at which friction changes. `friction`: by depth, downward, the first from the top on;
/// empty: none.
Contact make_contact(const std::vector<Section>& sections, const Survey& survey,
                     const std::vector<FrictionBelow>& friction, int elements);

/// Side force of all nodes, N, from the tension of all elements, N. Allocates nothing where
/// `side_force` has the size of the nodes.
void side_forces(const Contact& contact, const std::vector<double>& tension,
                 std::vector<double>& side_force);

/// Side force of one node, N, whose neighbouring elements pull with these tensions, N.
double side_force_at(const Contact& contact, int node, double above, double below);

}  // namespace tdbd::string
