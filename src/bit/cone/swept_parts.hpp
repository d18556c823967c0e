#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// For a cone whose teeth come from mesh files, returns one tooth of each row, as indices into
/// bit.parts. Teeth are in one row if they reach the same distances along and from the journal, to
/// within `apart` (m).
std::vector<int> one_tooth_of_each_row(const Bit& bit, int cone, double apart);

/// Returns the cutting parts of a bit, with every row of a cone replaced by the surface that its
/// teeth sweep in a full turn of the cone. It is row_meridian rotated about the journal, a surface
/// in K without end caps, named after its row ("cone-1/row-2"). For cones from mesh files, the
/// surface is swept by one tooth of each row (swept_meridian). A cone's body that cuts is not
/// changed, because it turns about its own axis. The corners of a row are on inscribed circles of
/// `segments` points. At some time some tooth reaches every point of such a part, and no tooth
/// reaches beyond it by more than radius (pi/segments)^2/2. For a bit without cones, the cutting
/// parts are returned unchanged.
std::vector<Part> swept_parts(const Bit& bit, int segments = 720);

}  // namespace tdbd::bit
