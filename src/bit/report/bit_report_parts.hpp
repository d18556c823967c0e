#pragma once

#include <nlohmann/json.hpp>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// [x, y, z]
nlohmann::ordered_json vector_json(const Vec3& v);

/// Every part, in the order of the numbers in bit.vtp: name, kind, whether it cuts, cutter and cone
/// (-1: of none), volume, density, origin in the bit frame, update direction at azimuth 0.
nlohmann::ordered_json parts_json(const Bit& bit);

/// Adds to a cutter's entry where it is in the bit frame: tip, centre of the face, axes of its
/// frame (thesis: 3.2.2) and the profile's normal.
void add_placing(const Cutter& c, nlohmann::ordered_json& entry);

/// Adds `body_profile_rz_m`: what the body's parts reach when turned into one half-plane, below
/// their middle. Absent when the bit has no body, or cones: then the body is a shank.
void add_body_profile(const Bit& bit, nlohmann::ordered_json& file);

/// Adds `cones`, as in bit.json, each with `sections`: meridians of its shell and of what its rows
/// sweep, about the journal (s, r) and in the bit's half-plane (r, z) where the cone is deepest;
/// and `clearances` between cones (bit/cone/cone_interference.hpp).
void add_cones(const Bit& bit, nlohmann::ordered_json& file);

}  // namespace tdbd::bit
