// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/dynamics/tracking_simulation.hpp"

namespace lamina {

/// What becomes of faces of the part that no bead comes near.
enum class UncoveredFaces {
  Count,  ///< they are underfilled in full
  Skip,   ///< they are left out, as in [Guacheta2021, listing A.16]
};

/// The line of a bead that is followed.
enum class BeadLine {
  Middle,  ///< half its height behind the tip along the tool axis, where the paths of [Guacheta2021] are
  Tip,     ///< of the nozzle, as [Guacheta2021] takes G-code
};

/// How wide a bead looks on a face; |n_z| is 0 on vertical faces and 1 on horizontal ones.
enum class SurfaceWidth {
  Code,  ///< 0.2 mm (1 + |n_z|): 0.2 to 0.4 mm, as in [Guacheta2021, listing A.16]
  Text,  ///< 0.2 mm + 0.15 mm |n_z|: 0.2 to 0.35 mm, as in [Guacheta2021, section 4.2.1]
  Bead,  ///< of the bead itself: its height seen across the tool axis, the plan width it fills seen along it
};

/// Which pieces of the path a face is covered by.
enum class FacePieces {
  Near,    ///< those that reach over it, also from beside it; faces of one plane count as one would
  Within,  ///< what lies above or below it, with round ends where it is cut off, as in [Guacheta2021]
};

/// Which overlaps are overfill.
enum class Overlaps {
  Apart,  ///< those of pieces that do not follow each other; joined ones meet at their bisector
  All,    ///< also the round ends of joined pieces on each other, as in [Guacheta2021]
};

/// Cross-section from which the volume is estimated.
enum class VolumeSection {
  Strand,  ///< one section all along, as in [Guacheta2021, eq. 4.6]
  Bead,    ///< of each bead itself
};

/// What is taken off the length of each segment before its volume is estimated; D is the diameter of a disc
/// of the section.
enum class StrandEnds {
  Whole,       ///< nothing, as in [Guacheta2021, eq. 4.6]
  Generated,   ///< D, as [Guacheta2021, listing A.19] does for its own paths
  Commercial,  ///< D / 2, as it does for those of other slicers
};

/// Settings of the surface metrics.
struct SurfaceFillSettings {
  /// Depth [mm] below a face within which a bead counts for it; 0.25 in [Guacheta2021]. 0: half of what
  /// the bead measures across the face and a quarter of its height, which is as much for a bead of 0.4 x 0.2
  /// mm at an upright face.
  double depth_mm = 0.0;
  BeadLine line = BeadLine::Middle;
  SurfaceWidth width = SurfaceWidth::Bead;
  FacePieces pieces = FacePieces::Near;
  Overlaps overlaps = Overlaps::Apart;
  UncoveredFaces uncovered = UncoveredFaces::Count;
  double step_mm = 0.02;  ///< between the lines along which areas are measured, at most
};

/// Settings of the volume error.
struct VolumeErrorSettings {
  VolumeSection section = VolumeSection::Bead;
  double strand_area_mm2 = 0.08;
  StrandEnds ends = StrandEnds::Whole;
  double fill_share = 1.0;  ///< of the part's volume that is asked for
};

/// Settings of the simulated platform.
struct PlatformRunSettings {
  /// Where the middle of what is deposited stands on the bed [mm]; empty leaves it where it is.
  std::vector<double> middle_mm = {0.0, 0.0};
  TrackingSettings tracking;
};

/// How the nine metrics are taken.
struct MetricsSettings {
  bool measures_surface = true;
  bool simulates_platform = false;    ///< which takes longest by far
  std::vector<std::string> left_out;  ///< metrics of plug-ins that are not measured; no setting of its own
  double speed_mm_s = 50.0;           ///< of every motion, instead of its feed; 0 for its feed
  double acceleration_mm_s2 = 1000.0;
  SurfaceFillSettings surface;
  VolumeErrorSettings volume;
  PlatformRunSettings platform;
};

/// Adds the keys metrics.*, and those of the simulated platform: platform.*, controller.*, simulation.*.
void describe(SettingsSchema& schema, MetricsSettings& settings);

}  // namespace lamina
