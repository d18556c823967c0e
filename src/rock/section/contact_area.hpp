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
  std::vector<Vec3> near_P;  ///< m, their places at the end of the step
  std::vector<int> held;
  std::vector<int> mark;  ///< per vertex: stamp of the part that holds it
  std::vector<int> index;
  int stamp = 0;
  /// A vertex of the triangles around the part's contact.
  struct Place {
    Vec3 x_P = Vec3::Zero(), d_P = Vec3::Zero();  ///< m
    bool is_held = false;
    std::optional<bool> is_lee{};  ///< computed only if the contact depends on it
    bool is_inside = false;        ///< on the lee side, with its undisturbed place inside the part
  };
  std::vector<Place> places;
  /// The end of the contact on an edge that two triangles share, for the part with this stamp.
  struct KnownEnd {
    int in = -1, out = -1, stamp = -1;
    ContactEnd end;
  };
  std::array<KnownEnd, 256> ends;  ///< indexed by a hash of the edge
  std::vector<PressedVertex> inherited, pressed;
};

/// Buffers for the contact areas of a step, kept between steps to avoid allocations.
struct ContactWork {
  PerThread<ContactScratch> scratch;
  std::vector<InterpolatedDisplacement> carried;
  std::vector<int> mark;  ///< per vertex
  int stamp = 0;
  std::vector<Vec3> places_W;  ///< buffer of apply_residues
};

/// Rock surface in contact with a part of the bit. All zero if there is none.
///
/// If the stress of the law increases with the angle b of the motion into the rock (forces (4)),
/// every polygon counts with the share w = min(1, tan b / ramp) of the full stress; w = 0 if it
/// does not move into the rock. Without a ramp w = 1. The area vector is
///   sum(w A n) / w_m
/// where w_m is the share at the mean normal, sum(w A n), and the mean point. It is the area vector
/// of a surface that moves uniformly like its middle and bears the same force under the law. So a
/// surface that only slides adds nothing, and the exact end of a contact along it does not matter.
struct ContactPatch {
  double area = 0.0;                  ///< m2, sum of the areas A of the contact's polygons
  Vec3 area_vector_W = Vec3::Zero();  ///< m2; n: the polygons' normals out of the rock
  Vec3 centroid_W = Vec3::Zero();     ///< m, mean of the polygons, weighted by w A
};

/// A part's contact. Sides that press and do not face the update direction are separate from the
/// surface below them, because they crush rock while the surface below may only slide, as where a
/// pad drags.
struct PartContact {
  ContactPatch below, sides;
  /// The surface below, divided by the direction of the part's frame (-x, x, -y, y, -z or z) that
  /// it faces most. Only for parts with ContactDivision::by_direction.
  std::array<ContactPatch, 6> facing{};
  /// m, distance of the part's surface from the nearest vertex that it presses. Within the gap,
  /// this is how far the part has risen from the rock.
  double distance = 0.0;
};

/// Combines both patches into one, with one mean normal.
inline ContactPatch whole(const PartContact& c) {
  ContactPatch sum{c.below.area + c.sides.area, c.below.area_vector_W + c.sides.area_vector_W};
  if (sum.area > 0.0)
    sum.centroid_W =
        (c.below.area * c.below.centroid_W + c.sides.area * c.sides.centroid_W) / sum.area;
  return sum;
}

/// How a part's contact is measured.
enum class ContactRule {
  clipped,         ///< by rock (14)
  whole_triangles  ///< triangles with three held vertices; lacks a strip along the border
};

/// Whether the surface below is one patch, or one for each direction of the part's frame. A milled
/// tooth presses with its crest and one flank at once. With one mean normal, each of them would
/// follow the motion of the other.
enum class ContactDivision { none, by_direction };

struct ContactOfPart {
  ContactRule rule = ContactRule::clipped;
  double ramp = 0.0;  ///< forces::Pressing::ramp of its law
  /// Unit vector or zero. The plane of a convex part with this outward normal is left out because
  /// its contact is measured in another way. Vertices that it holds count as on the part's lee
  /// side.
  Vec3 excluded_normal_P = Vec3::Zero();
  ContactDivision division = ContactDivision::none;
};

struct ContactOptions {
  double gap = 0.0;                        ///< m, largest distance that counts as touching
  std::span<const ContactOfPart> by_part;  ///< empty: the defaults
};

/// Computes the contact area of every part of the bit, rock (14) (reconstructed). A part holds the
/// vertices that it moved in this step and those within the gap of its surface at the end of the
/// step. Of these it presses the ones that are not on its lee side. In every triangle with such
/// corners, the contact is the polygon of these corners and of the two points at which the contact
/// ends (contact_end.hpp). A triangle may count for several parts.
///
/// Updates rock.pressed: the displacement of each held vertex by the part during uninterrupted
/// contact. Where maintenance made or moved vertices since the last call, displacements are
/// interpolated on the previous surface. Must be called once after each cut_rock and before
/// maintenance. `cut`: the workspace of that step. Parts that leave rock inside themselves bear on
/// the surface that they would leave if they removed all of it (rock (22)). The run time is
/// proportional to the number of vertices near the bit.
void contact_areas(Rock& rock, const CuttingBit& bit, const CutWorkspace& cut,
                   const ContactOptions& options, ContactWork& work,
                   std::vector<PartContact>& contact_by_part);

}  // namespace tdbd::rock
