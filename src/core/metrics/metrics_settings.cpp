// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/metrics_settings.hpp"

namespace lamina {
namespace {

void describe(SettingsSchema& schema, SurfaceFillSettings& settings) {
  schema.number("metrics.depth_mm", settings.depth_mm, {0.0, 1000.0},
                "Depth below a face within which a bead counts for it; 0 takes what fits the bead.");
  schema.choice<BeadLine>("metrics.bead_line", settings.line,
                          {{"middle", BeadLine::Middle}, {"tip", BeadLine::Tip}},
                          "Whether beads lie where their middle is, or the nozzle's tip.");
  schema.choice<SurfaceWidth>(
      "metrics.surface_width", settings.width,
      {{"code", SurfaceWidth::Code}, {"text", SurfaceWidth::Text}, {"bead", SurfaceWidth::Bead}},
      "How wide a bead looks on a face: 0.2 to 0.4 mm, 0.2 to 0.35 mm, or its own height to what it fills.");
  schema.choice<FacePieces>(
      "metrics.face_pieces", settings.pieces, {{"near", FacePieces::Near}, {"within", FacePieces::Within}},
      "Whether beads beside a face that reach over it cover it, or only those below it.");
  schema.choice<Overlaps>("metrics.overlaps", settings.overlaps,
                          {{"apart", Overlaps::Apart}, {"all", Overlaps::All}},
                          "Whether overlaps of joined segments at corners are left out of the overfill.");
  schema.choice<UncoveredFaces>(
      "metrics.uncovered_faces", settings.uncovered,
      {{"count", UncoveredFaces::Count}, {"skip", UncoveredFaces::Skip}},
      "Whether faces that no bead comes near are underfilled in full, or left out.");
  schema.number("metrics.surface_step_mm", settings.step_mm, Bounds::above(0.0, 1.0),
                "Distance between the lines along which areas on faces are measured, at most.");
}

void describe(SettingsSchema& schema, VolumeErrorSettings& settings) {
  schema.choice<VolumeSection>("metrics.volume_section", settings.section,
                               {{"strand", VolumeSection::Strand}, {"bead", VolumeSection::Bead}},
                               "Whether volume is that of a strand of one section, or of the beads.");
  schema.number("metrics.strand_area_mm2", settings.strand_area_mm2, Bounds::above(0.0, 100.0),
                "Section of that strand.");
  schema.choice<StrandEnds>("metrics.strand_ends", settings.ends,
                            {{"whole", StrandEnds::Whole},
                             {"generated", StrandEnds::Generated},
                             {"commercial", StrandEnds::Commercial}},
                            "What each segment's volume leaves out: nothing, a diameter, or half of one.");
  schema.number("metrics.fill_share", settings.fill_share, {0.0, 1.0},
                "Share of the part's volume that is asked for.");
}

}  // namespace

void describe(SettingsSchema& schema, MetricsSettings& settings) {
  schema.flag("metrics.surface", settings.measures_surface, "Whether under- and overfill are measured.");
  schema.flag("metrics.simulate_platform", settings.simulates_platform,
              "Whether the six-legged platform is simulated for energy and tracking errors.");
  schema.number("metrics.speed_mm_s", settings.speed_mm_s, {0.0, 1e4},
                "Speed of every motion in the metrics; 0 for the toolpath's own feeds.");
  schema.number("metrics.acceleration_mm_s2", settings.acceleration_mm_s2, Bounds::above(0.0, 1e6),
                "Acceleration of every motion in the metrics, from rest to rest.");
  describe(schema, settings.surface);
  describe(schema, settings.volume);
  schema.numbers(
      "metrics.platform_middle_mm", settings.platform.middle_mm, 2,
      "Where the middle of the part stands on the simulated platform's bed; empty for where it is.");
  describe(schema, settings.platform.tracking);
}

}  // namespace lamina
