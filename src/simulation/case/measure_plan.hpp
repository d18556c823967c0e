#pragma once

namespace tdbd::simulation {

enum class SectionMeasure { off, ahead };
enum class ContactMeasure { off, on };

/// What a run measures in every step for forces (formulation 2.6).
struct MeasurePlan {
  SectionMeasure section = SectionMeasure::ahead;
  double section_lead = 1.2;  ///< over the rock's edge length (rock::SectionPlace)
  ContactMeasure contact = ContactMeasure::on;
  double contact_gap = 0.01;  ///< over the rock's edge length (rock::contact_areas)
};

}  // namespace tdbd::simulation
