#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// The meridian of a solid of revolution about a cone's axis: a polygon of points (s, r), r >= 0. A
/// side along the axis is not part of the surface.
using Meridian = std::vector<ShellPoint>;

/// Signed distance (m) of the point (s, r) from a solid of revolution, negative inside. It is also
/// the distance in space of any point at (s, r).
double signed_distance(const Meridian& solid, const ShellPoint& p);

/// The meridian of a shell: its profile, closed to the axis at both ends.
Meridian shell_meridian(const std::vector<ShellPoint>& shell);

/// A convex polygon that contains the meridian of the volume that a convex part sweeps in a full
/// turn of its cone. Each of its corners is reached by a corner of the mesh or lies vertically
/// below one, towards the axis. So its outer side is exact, and its inner side is too low by at
/// most y^2/(2 r).
Meridian swept_meridian(const mesh::TriangleMesh& convex_P, const Pose& X_KP);

/// Makes a closed convex mesh of a tooth in its frame T, from -embedding to +protrusion. An insert
/// is a cylinder with a hemisphere, a round-tipped cone or a chisel on top; a milled tooth is a
/// wedge from a rectangle to its crest. The mesh is a stack of outlines normal to Z. Each outline
/// is a segment along X widened by a disc, with corners at the same angles, so that every side is
/// flat. An outline has `facets` corners (a multiple of 4; a milled tooth has 4), all on the
/// tooth's true surface.
mesh::TriangleMesh tooth_mesh(const ToothShape& shape, int facets);

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

/// Frame T of a row's tooth at an angle (rad) about the cone's Z, in K: origin on the shell,
/// lowered by the row's sink; Z is the shell's normal rotated by the row's lean; X along the
/// meridian towards the base.
Pose tooth_pose(const ConeLayout& cone, const ToothRow& row, double angle);

/// Makes the parts cone-K/body and cone-K/row-J/tooth-I (K, J, I from 1): closed meshes at the
/// cone's angle 0. The body cuts only if the layout requires it; the teeth always cut. `index`: the
/// cone's index in the bit (Part::cone). set_tooth_directions sets the teeth's update directions. Thesis:
/// 3.1, fig. 3.5.
std::vector<Part> cone_parts(const Cone& cone, int index);

/// The meridian of the volume that the row's teeth sweep in a full turn of the cone.
Meridian row_meridian(const ConeLayout& cone, const ToothRow& row);

/// Angles (rad, ascending, in [0, 2 pi)) of `teeth` teeth, starting at `first_angle`. The gaps
/// between them have the ratios of `pattern`, which is repeated as needed and may be truncated. An
/// empty pattern means equal gaps. The sum of all gaps is one turn.
std::vector<double> spaced_angles(int teeth, double first_angle,
                                  const std::vector<double>& pattern);

}  // namespace tdbd::bit
