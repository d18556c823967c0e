#pragma once

#include "bit/cone.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// A point on the shell's meridian and the outward normal there, as (s, r) components. At a corner
/// of the profile the normal bisects the angle; at a nose on the axis it lies along the axis.
struct ShellPlace {
  ShellPoint point;
  ShellPoint normal;
};

/// The shell at s (m), which must lie between the shell's ends.
ShellPlace shell_place(const std::vector<ShellPoint>& shell, double s);

/// Makes a closed mesh of the cone's body in K: the inscribed surface of revolution of the shell
/// about the journal, with flat ends. Thesis: 3.1.
mesh::TriangleMesh shell_mesh(const ConeLayout& cone);

/// The same solid as a stack of convex frustums, one for each piece of the profile.
std::vector<mesh::TriangleMesh> shell_pieces(const ConeLayout& cone);

}  // namespace tdbd::bit
