#pragma once

namespace tdbd::reference {

/// Slow twin of virgin_groove: the area (m2), normal to the motion, of the cut of a round face of
/// this diameter (m) that leans back by an angle (rad) and reaches this deep (m) into flat rock.
/// Sums over strips of the ellipse that is the face's projection along the motion.
double groove_area_by_strips(double diameter, double back_rake, double depth, int strips);

}  // namespace tdbd::reference
