#pragma once

namespace tdbd::reference {

/// The slow twin of virgin_groove: the area (m2), normal to the motion, of the cut of a round face
/// of this diameter (m), leaning back by an angle (rad), that reaches this deep (m) into flat rock:
/// a sum over strips of the ellipse that the face shows to the motion.
double groove_area_by_strips(double diameter, double back_rake, double depth, int strips);

}  // namespace tdbd::reference
