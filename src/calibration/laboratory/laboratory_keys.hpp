#pragma once

#include "core/config/key.hpp"
#include "forces/law.hpp"

namespace tdbd::calibration::laboratory_keys {

inline constexpr TableKey table{"laboratory", "tests that a synthetic laboratory makes"};
inline constexpr NameKey law{.name = "law",
                             .names = &forces::law_names,
                             .usual = "required",
                             .meaning = "the true force law; its coefficients are in [truth]"};
inline constexpr TextsKey bits{
    .name = "bits", .usual = "all of [bits]", .meaning = "the bits that are tested"};
inline constexpr ListKey pressures{.name = "pressures",
                                   .unit = "Pa",
                                   .usual = "required",
                                   .meaning = "of the bottom hole; one test for each bit and one"};
inline constexpr ListKey rates{.name = "rates",
                               .unit = "m/s",
                               .usual = "required",
                               .meaning = "of penetration, one reading each in every test"};
inline constexpr QuantityKey rotary_speed{
    .name = "rotary_speed", .unit = "rad/s", .range = Range::positive(), .meaning = "of all tests"};
inline constexpr IntegerKey seed{.name = "seed", .fallback = 1, .meaning = "of the noise"};
inline constexpr TableKey truth{"truth", "KEY = value: the true coefficients"};
inline constexpr TableKey area{
    "areas.NAME",
    "parts of the bits that meet all criteria and have true coefficients of their own"};
inline constexpr TableKey area_truth{"areas.NAME.truth",
                                     "KEY = value: the true coefficients of the area"};
inline constexpr AnyKey any_area_coefficient{
    .name = "KEY",
    .kind = "that of the coefficient",
    .usual = "that of the parts in no area",
    .meaning = "a coefficient of the law, as [forces] has it"};
inline constexpr AnyKey any_coefficient{.name = "KEY",
                                        .kind = "that of the coefficient",
                                        .usual = "the coefficient's",
                                        .meaning = "a coefficient of the law, as [forces] has it"};

}  // namespace tdbd::calibration::laboratory_keys
