#pragma once

#include "bit/bit.hpp"
#include "bit/files/bit_parts.hpp"

namespace tdbd::bit {

/// The numbers of a cutter whose parts are meshes: those that place it follow from its frame,
/// the inverse of cutter_pose, and its shape follows from the vertices of face and chamfer. The frame
/// is moved along X to the front of the face. None: the parts have no flat rim normal to X, or the
/// face does not look forwards.
std::optional<Cutter> cutter_from_meshes(Pose X_BC, const std::vector<Part>& parts);

/// Adds to the bit a cutter for every face whose cutter's frame is known (PartsFromFiles::frames) and
/// that is the only face of its group; the cutter's parts (Part::cutter) are those of the group. Faces
/// for which cutter_from_meshes has none stay parts without a cutter. The cutters have the numbers of
/// their parts' names, "cutter-12/face", if all have one of their own; otherwise 1, 2, ...
void add_cutters(const PartsFromFiles& read, Bit& bit);

}  // namespace tdbd::bit
