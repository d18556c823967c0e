#pragma once

#include "bit/bit.hpp"
#include "bit/files/bit_parts.hpp"

namespace tdbd::bit {

/// Computes the table values of a cutter whose parts are meshes. Its place follows from its frame (the
/// inverse of cutter_pose), its diameter and chamfer from the vertices of face and chamfer. The frame
/// is first moved along X to the front of the face. Returns nothing if the parts have no flat rim
/// normal to X, or if the face does not point forwards.
std::optional<Cutter> cutter_from_meshes(Pose X_BC, const std::vector<Part>& parts);

/// Makes cutters of the faces in bit.parts. A face becomes a cutter if its frame is given
/// (PartsFromFiles::frames), if it is the only face of its group, and if cutter_from_meshes returns
/// one; all parts of the group then belong to the cutter (Part::cutter). Other faces are left without
/// a cutter. Cutters are numbered by the names of their parts ("cutter-12/face") if all these numbers
/// differ, otherwise 1, 2, ...
void add_cutters(const PartsFromFiles& read, Bit& bit);

}  // namespace tdbd::bit
