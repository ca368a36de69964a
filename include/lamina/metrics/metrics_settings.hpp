// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/dynamics/tracking_simulation.hpp"

namespace lamina {

/// How faces of the part count if no bead comes near.
enum class UncoveredFaces {
  Count,  ///< as underfilled in full
  Skip,   ///< not at all, as in [Guacheta2021, listing A.16]
};

/// The line along which a bead is assumed to lie.
enum class BeadLine {
  Middle,  ///< half the bead's height behind the tip along the tool axis, as for the paths of [Guacheta2021]
  Tip,     ///< the path of the nozzle tip, as [Guacheta2021] does for G-code
};

/// Width that a bead is assumed to cover on a face; |n_z| is 0 on vertical faces and 1 on horizontal ones.
enum class SurfaceWidth {
  Code,  ///< 0.2 mm (1 + |n_z|): 0.2 to 0.4 mm, as in [Guacheta2021, listing A.16]
  Text,  ///< 0.2 mm + 0.15 mm |n_z|: 0.2 to 0.35 mm, as in [Guacheta2021, section 4.2.1]
  /// That of the bead: its height on faces along the tool axis, its plan width on faces across the tool axis.
  Bead,
};

/// Which pieces of the path cover a face.
enum class FacePieces {
  Near,    ///< all that reach over the face, also from beside it; faces in one plane count as one
  Within,  ///< pieces above or below the face, cut off with round ends, as in [Guacheta2021]
};

/// Which overlaps count as overfill.
enum class Overlaps {
  Apart,  ///< overlaps of pieces that do not follow each other; consecutive pieces are divided by their
          ///< bisector
  All,    ///< also overlaps of the round ends of consecutive pieces, as in [Guacheta2021]
};

/// Cross-section from which the volume is estimated.
enum class VolumeSection {
  Strand,  ///< the same section everywhere, as in [Guacheta2021, eq. 4.6]
  Bead,    ///< that of each bead
};

/// By how much the length of each segment is reduced before its volume is estimated; D is the diameter of a
/// disc with the area of the section.
enum class StrandEnds {
  Whole,       ///< nothing, as in [Guacheta2021, eq. 4.6]
  Generated,   ///< D, as [Guacheta2021, listing A.19] does for its own paths
  Commercial,  ///< D / 2, as the listing does for paths of other slicers
};

/// Settings of the surface metrics.
struct SurfaceFillSettings {
  /// Depth below a face within which a bead counts for it [mm]; 0.25 in [Guacheta2021]. 0 stands for half of
  /// the bead's extent across the face plus a quarter of its height, which is 0.25 mm as well for a bead of
  /// 0.4 x 0.2 mm at a vertical face.
  double depth_mm = 0.0;
  BeadLine line = BeadLine::Middle;
  SurfaceWidth width = SurfaceWidth::Bead;
  FacePieces pieces = FacePieces::Near;
  Overlaps overlaps = Overlaps::Apart;
  UncoveredFaces uncovered = UncoveredFaces::Count;
  double step_mm = 0.02;  ///< greatest distance of the lines along which areas are measured
};

/// Settings of the volume error.
struct VolumeErrorSettings {
  VolumeSection section = VolumeSection::Bead;
  double strand_area_mm2 = 0.08;  ///< cross-section for `VolumeSection::Strand`
  StrandEnds ends = StrandEnds::Whole;
  double fill_share = 1.0;  ///< share of the part's volume that should be filled
};

/// Settings of the simulated platform.
struct PlatformRunSettings {
  /// Position on the bed of the middle of the deposit, in x and y [mm]; empty to leave the deposit in place.
  std::vector<double> middle_mm = {0.0, 0.0};
  TrackingSettings tracking;
};

/// How the nine metrics are measured.
struct MetricsSettings {
  bool measures_surface = true;
  bool simulates_platform = false;    ///< takes by far the longest
  std::vector<std::string> left_out;  ///< metrics of plug-ins that are not measured; not a setting
  double speed_mm_s = 50.0;           ///< speed of every motion instead of its feed; 0 for its feed
  double acceleration_mm_s2 = 1000.0;
  SurfaceFillSettings surface;
  VolumeErrorSettings volume;
  PlatformRunSettings platform;
};

/// Adds the keys metrics.*, and those of the simulated platform: platform.*, controller.*, simulation.*.
void describe(SettingsSchema& schema, MetricsSettings& settings);

}  // namespace lamina
