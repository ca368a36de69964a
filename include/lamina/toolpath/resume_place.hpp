// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/laid_beads.hpp"

namespace lamina {

/// How a job that was cut off is resumed by the place on its toolpath.
struct ToolpathResumeSettings {
  /// How far before the place that is known it begins, along the bead: what is not known is whether the bead
  /// was laid up to there, as a machine that is left alone brakes with its process off.
  double overlap_mm = 2.0;
  double tolerance_mm = 0.5;  ///< of the nozzle from the toolpath where it came to rest
};

/// Adds the keys resume.overlap_mm and resume.tolerance_mm.
void describe(SettingsSchema& schema, ToolpathResumeSettings& settings);

/// Where a job that was cut off is resumed. All lengths are of beads [mm].
struct ResumePlace {
  double begin_mm = 0.0;      ///< what was laid before is not laid again
  double laid_mm = 0.0;       ///< up to where the nozzle stands, or else what was reported last
  bool is_found = false;      ///< whether the nozzle stands on the toolpath, so that the place is proven
  WaypointIndex heading_for;  ///< where it begins
  double total_mm = 0.0;
  double unreported_mm3 = 0.0;  ///< laid after what was reported last, as planned

  bool isAllLaid() const;
};

/// Where it is resumed: `overlap_mm` before where the nozzle came to rest on the toolpath, or before what was
/// reported last if it is not there; never before the bead begins.
/// @param reported_mm  what was reported last as laid
/// @param nozzle       where it came to rest, in the part frame [mm]; nothing if that is not known
ResumePlace resumePlace(const LaidBeads& beads, double reported_mm,
                        const std::optional<Eigen::Isometry3d>& nozzle,
                        const ToolpathResumeSettings& settings);

/// What is known and what is not, for who decides whether it is resumed.
std::string toText(const ResumePlace& place);

}  // namespace lamina
