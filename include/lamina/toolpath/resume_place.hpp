// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <limits>
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
  bool is_found = false;      ///< whether the nozzle stands on the toolpath, near what was reported
  WaypointIndex heading_for;  ///< where it begins
  double total_mm = 0.0;
  double unreported_mm3 = 0.0;  ///< laid after what was reported last, as planned

  bool isAllLaid() const;
};

/// What was reported last of a job, and how far the machine may be from it. All lengths are of beads [mm].
struct ReportedProgress {
  double laid_mm = 0.0;
  double behind_mm = 0.0;                                     ///< by which the machine may trail the report
  double ahead_mm = std::numeric_limits<double>::infinity();  ///< by which it may have gone beyond the report
  double most_rise_mm = std::numeric_limits<double>::infinity();  ///< as in `LaidSearch`
};

/// Where a job is resumed: `overlap_mm` before the place of the toolpath where the nozzle came to rest. If
/// the nozzle shows no such place, `overlap_mm` before the least that was laid by the report. Never before
/// the bead begins.
/// @param nozzle  its pose at rest, in the part frame [mm]; nothing if that is not known
/// @throws InvalidInput if the reported length is not finite, or negative
ResumePlace resumePlace(const LaidBeads& beads, const ReportedProgress& reported,
                        const std::optional<Eigen::Isometry3d>& nozzle,
                        const ToolpathResumeSettings& settings);

/// @param begin_mm  where a person has confirmed that the job begins, as `ResumePlace::begin_mm`
/// @throws InvalidInput with both lengths if it begins elsewhere by more than `kConfirmedPlace`
void requireConfirmed(const ResumePlace& place, double begin_mm);

/// What is known and what is not, for who decides whether it is resumed.
std::string toText(const ResumePlace& place);

}  // namespace lamina
