#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/section/contact_end.hpp"

namespace tdbd::rock {

/// Buffers of one thread.
struct ContactScratch {
  std::vector<int> chains, around;
  std::vector<int> near;     ///< vertices that a part of the group may touch
  std::vector<Vec3> near_P;  ///< m, the same at the end of the step
  std::vector<int> held;
  std::vector<int>
      mark;  ///< per vertex: the stamp of the part that holds it, and where in `places`
  std::vector<int> index;
  int stamp = 0;
  /// Vertices of the triangles around the part's contact.
  struct Place {
    Vec3 x_P = Vec3::Zero(), d_P = Vec3::Zero();  ///< m
    bool is_held = false;
    std::optional<bool> is_lee{};  ///< found only if the contact depends on it
    bool is_inside = false;        ///< on the lee side, its undisturbed place inside the part
  };
  std::vector<Place> places;
  /// Where the contact ends on an edge that two triangles share; of the part with this stamp.
  struct KnownEnd {
    int in = -1, out = -1, stamp = -1;
    ContactEnd end;
  };
  std::array<KnownEnd, 256> ends;  ///< by a hash of the edge
  std::vector<PressedVertex> inherited, pressed;
};

/// Buffers for the contact areas of a step, kept between steps so that none allocates once warm.
struct ContactWork {
  PerThread<ContactScratch> scratch;
  std::vector<CarriedDisplacement> carried;
  std::vector<int> mark;  ///< per vertex
  int stamp = 0;
  std::vector<Vec3> places_W;  ///< show_passed
};

/// Rock surface in contact with a part of the bit. All zero: none.
///
/// Under a law whose stress increases with the angle b of the motion into the rock (forces (4)) every
/// polygon has the share w = min(1, tan b / ramp) of the full stress, 0 where it does not move into the
/// rock; without a ramp w = 1. The area vector is
///   sum(w A n) / w_m
/// where w_m is the share at the mean normal, sum(w A n), and the mean point: that of the surface which
/// has the same force under the law if all of it moves like its middle. So a surface that only slides
/// adds nothing, and it does not matter where exactly a contact ends along it.
struct ContactPatch {
  double area = 0.0;                  ///< m2, sum of the areas A of the contact's polygons
  Vec3 area_vector_W = Vec3::Zero();  ///< m2, n: the polygons' normals out of the rock
  Vec3 centroid_W = Vec3::Zero();     ///< m, of the polygons, weighted by w A
};

/// A part's contact. Sides that press and do not face the update direction are apart from the surface
/// below them: they are crushing rock while that may only slide, as where a pad drags.
struct PartContact {
  ContactPatch below, sides;
  /// The surface below once more, divided by the direction of the part's frame, -x, x, -y, y, -z or z,
  /// that it faces most; of parts with ContactDivision::by_direction.
  std::array<ContactPatch, 6> facing{};
  /// m, from the part's surface to the nearest vertex that it presses: how far it has risen from the
  /// rock since, within the gap.
  double distance = 0.0;
};

/// Both patches as one, which has one normal.
inline ContactPatch whole(const PartContact& c) {
  ContactPatch sum{c.below.area + c.sides.area, c.below.area_vector_W + c.sides.area_vector_W};
  if (sum.area > 0.0)
    sum.centroid_W =
        (c.below.area * c.below.centroid_W + c.sides.area * c.sides.centroid_W) / sum.area;
  return sum;
}

/// How a part's contact is measured.
enum class ContactRule {
  clipped,         ///< rock (14)
  whole_triangles  ///< triangles with three held vertices: lacks a strip along the border
};

/// Whether the surface below is one patch, or one for each direction of the part's frame. A
/// milled tooth presses with its crest and a flank at once; under one normal between them each would follow the
/// motion of the other.
enum class ContactDivision { none, by_direction };

struct ContactOfPart {
  ContactRule rule = ContactRule::clipped;
  double ramp = 0.0;  ///< forces::Pressing::ramp of its law
  /// Unit, or zero: a plane of a convex part with this outward normal is left out, since its contact
  /// is measured otherwise. What it holds counts as on the part's lee side.
  Vec3 left_out_P = Vec3::Zero();
  ContactDivision division = ContactDivision::none;
};

struct ContactOptions {
  double gap = 0.0;                        ///< m, how near counts as touching
  std::span<const ContactOfPart> by_part;  ///< empty: the defaults
};

/// The contact area of every part of the bit, rock (14) (reconstructed). A part holds the vertices
/// that it moved in this step or touches at its end, that is, has within the gap of its
/// surface; it presses those of them that are not on its lee side. Of every triangle with such corners the
/// contact is the polygon of these corners and of the two points at which it ends (contact_end.hpp).
/// A triangle may count for several parts.
///
/// Updates rock.pressed: by how much each held vertex was moved by the part since the two have been
/// in contact without a break of one step. Where maintenance made or moved vertices since, the
/// displacements are interpolated on the surface before. Call it once after each cut_rock and before maintenance; `cut` is the
/// workspace of that step. Parts that leave rock inside themselves bear on the surface that they would
/// leave if they removed all (rock (22)). Cost is proportional to the vertices near the bit.
void contact_areas(Rock& rock, const CuttingBit& bit, const CutWorkspace& cut,
                   const ContactOptions& options, ContactWork& work,
                   std::vector<PartContact>& contact_by_part);

}  // namespace tdbd::rock
