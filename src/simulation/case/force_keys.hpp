#pragma once

#include "core/config/key.hpp"
#include "forces/law.hpp"

namespace tdbd::simulation {

/// What the area cut by a face is taken from: the section ahead of it (ours), or the volume that it
/// removed (reconstructed).
enum class CutMeasure { section, volume };

/// What a chamfer's contact is taken from: the engaged edge times its width (ours), or the rock
/// triangles that it moved or touches (reconstructed).
enum class ChamferMeasure { edge, triangles };

/// What the contact of a cutter's wear flat is taken from: the flat behind the engaged part of its
/// edge (ours), or the rock triangles that the cutter's body moved or touches.
enum class FlatMeasure { edge, triangles };

namespace force_keys {

inline constexpr TableKey table{
    "forces", "the force law of every kind of part that it supports, except cutter bodies"};
inline constexpr TableKey kind_table{
    "forces.KIND",
    "another law for one kind of part (KIND): face, chamfer, cse, cutter_body, gage_pad, bit_body, "
    "cone, tooth; its coefficients stand beside it"};

inline constexpr TableKey areas_table{"forces.areas.NAME",
                                      "another law, or other coefficients, for the parts that meet "
                                      "all criteria given here; of several "
                                      "areas the one with the most particular criterion decides"};
inline constexpr TableKey areas{"areas", areas_table.meaning};
inline constexpr NameKey area_law{
    .name = "law",
    .names = &forces::law_names,
    .usual = "that of coefficients; else that of the parts, with the coefficients given here",
    .meaning = "its coefficients are keys beside it, as in [forces]"};

/// The names of the sets of coefficients from the literature.
inline std::vector<std::string_view> fit_names() {
  std::vector<std::string_view> names;
  for (const forces::Fit& fit : forces::known_fits()) names.push_back(fit.name);
  return names;
}

inline constexpr NameKey law{
    .name = "law",
    .names = &forces::law_names,
    .usual = "that of coefficients; else required",
    .meaning = "its coefficients are keys beside it, see the tables below"};
inline constexpr NameKey coefficients{
    .name = "coefficients",
    .names = &fit_names,
    .usual = "none",
    .meaning = "a law with a set of coefficients from the literature; keys beside it change them"};
inline constexpr ChoiceKey<CutMeasure> cut{
    .name = "cut",
    .values = {{{"section", CutMeasure::section}, {"volume", CutMeasure::volume}}},
    .fallback = CutMeasure::section,
    .meaning = "what a face cuts: the section ahead of it, or its removed volume over its path"};
inline constexpr ChoiceKey<ChamferMeasure> chamfer_contact{
    .name = "chamfer_contact",
    .values = {{{"edge", ChamferMeasure::edge}, {"triangles", ChamferMeasure::triangles}}},
    .fallback = ChamferMeasure::edge,
    .meaning = "a chamfer's contact: engaged edge times width, or the triangles that it touches"};

inline constexpr ChoiceKey<FlatMeasure> flat_contact{
    .name = "flat_contact",
    .values = {{{"edge", FlatMeasure::edge}, {"triangles", FlatMeasure::triangles}}},
    .usual = "\"edge\" with [wear], else \"triangles\"",
    .meaning =
        "what of a cutter's wear flat bears, by the law of its body: the flat behind the "
        "engaged part of its edge, or the triangles that it touches"};

/// A coefficient of a law as a key.
inline QuantityKey key_of(const forces::LawField& field) {
  return {.name = field.key,
          .unit = field.unit,
          .fallback = field.fallback,
          .range = field.range,
          .meaning = field.meaning};
}

}  // namespace force_keys

}  // namespace tdbd::simulation
