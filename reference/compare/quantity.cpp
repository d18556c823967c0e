#include "reference/compare/quantity.hpp"

#include <array>

namespace tdbd::reference {
namespace {

constexpr std::array<QuantityText, quantity_count> quantities{{
    {"weight", "N", "mean force of the bit on the rock along the hole, at the case's rate"},
    {"torque", "N m", "mean torque that turns the bit, at the case's rate"},
    {"work_of_a_turn_torque", "N m",
     "T + W d / 2 pi: work of a turn over 2 pi, which is eps R^2 d / 2 for a sharp bit"},
    {"rate_at_weight", "m/s", "rate of penetration at the reference weight"},
    {"torque_at_weight", "N m", "torque at the reference weight"},
    {"imbalance", "1", "mean lateral force in the bit's frame over weight"},
    {"imbalance_direction", "rad", "of that force in the bit's frame"},
    {"side_force", "N", "mean magnitude of the lateral force of a step"},
    {"removed_per_revolution", "m3", "rock that the bit removes in a revolution"},
    {"cone_speed_ratio", "1", "mean speed of the cones over the bit's, rolling positive"},
    {"teeth_in_contact", "1", "mean number of teeth that touch rock"},
    {"teeth_in_contact_variance", "1", "variance of that number over steps"},
    {"torque_noise", "1", "rms deviation of a step's torque over its mean"},
    {"torque_noise_5ms", "1", "the same of means over 5 ms"},
    {"torque_noise_by_crossing", "1",
     "noise where a force acts only in the steps in which its cutter crosses a spoke"},
    {"share_moved_backwards", "1", "cutters that move backwards, share of cutters and time"},
    {"resolution_at_gage", "m", "distance of neighbouring samples of the bottom at the gage"},
    {"largest_wear_flat", "m2", "largest wear flat after the case's distance"},
    {"hottest_flat", "degC", "temperature of the hottest wear flat then"},
    {"rate_of_penetration", "m/s", "mean rate that a bit on a string finds"},
    {"whirl_radius", "m", "rms distance of the bit's origin from the hole's axis, on a string"},
}};

constexpr std::array<QuantityText, part_quantity_count> part_quantities{{
    {"area", "m2", "mean area cut, normal to the circle on which the cutter turns"},
    {"volume_per_revolution", "m3", "rock that it removes in a revolution"},
    {"force_into_rock", "N", "mean force along the normal into the rock"},
    {"drag", "N", "mean force along the motion"},
    {"wear_flat", "m2", "area of its wear flat after the case's distance"},
    {"temperature", "degC", "of its wear flat then"},
    {"bending_moment", "N m", "magnitude of the moment about the face's centre"},
    {"cone_speed_ratio", "1", "speed of the cone over the bit's, rolling positive"},
    {"teeth_in_contact", "1",
     "mean number of its teeth that touch rock; of a tooth, its share of the time"},
    {"weight", "N",
     "mean force on the rock along the hole: teeth add up to their row, rows and shell to the "
     "cone"},
    {"largest_weight", "N", "largest of that force in a step that counts"},
}};

}  // namespace

std::span<const QuantityText> quantity_texts() { return quantities; }
std::span<const QuantityText> part_quantity_texts() { return part_quantities; }
const QuantityText& text_of(Quantity q) { return quantities[static_cast<std::size_t>(q)]; }
const QuantityText& text_of(PartQuantity q) { return part_quantities[static_cast<std::size_t>(q)]; }

}  // namespace tdbd::reference
