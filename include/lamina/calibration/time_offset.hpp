// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// How late the sensor's time stamps are: a profile stamped t was measured at t - offset_s.
struct TimeOffset {
  double offset_s = 0.0;
  double spread_s = 0.0;         ///< standard deviation of the offset
  double scatter_s = 0.0;        ///< standard deviation of `pieces_s`, skew left out; 0 if there is one alone
  double drift_s_per_min = 0.0;  ///< slope of `pieces_s` over the recording; 0 if there are fewer than three
  /// 1 at best. Of bobbing: correlation of depth and height. Of passes: root of 1 less the mean squared
  /// difference of heights at the best offset over that at the worst.
  double agreement = 0.0;
  std::size_t profiles = 0;      ///< number of profiles used
  std::vector<double> pieces_s;  ///< offset by each tenth of the bobbing, or by each pair of passes
  /// Angle about the viewing direction by which the sensor's line is turned, as overlapping passes show it.
  double skew_deg = 0.0;
  /// Of passes: whether the skew can be told from the offset, as neighbours lie on both sides; true also
  /// where passes repeat one track.
  bool is_skew_separable = false;
};

/// The time offset of a sensor that bobs (moves up and down) over a flat place: the lag at which the mean
/// depth of the profiles agrees best with the nozzle's height, each less its moving mean over 2 s. Lags are
/// tried every millisecond, and the best one is refined by a parabola. Gaps between profiles or between poses
/// are left out, as are times within 1 s of gaps longer than 0.25 s. The pose of the sensor need not be
/// known, but it must look along the nozzle.
///
/// @param search_s  greatest offset looked for, either way; positive
/// @throws InvalidInput if the recording is shorter than 4 s or longer than 600 s, gaps leave less than 0.3
///   of it, the nozzle moves less than 0.05 mm rms, profiles do not follow it (correlation below 0.8), the
///   best lag lies at the end of the search, or another lag is as good because the motion repeats itself
TimeOffset offsetByBobbing(const SensorRecording& recording, double search_s);

/// How passes in opposite directions of travel are compared.
struct PassComparison {
  double search_s = 0.6;   ///< greatest offset looked for, either way; positive
  double column_mm = 0.5;  ///< width of the strips, parallel to the travel, in which heights are compared
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();  ///< [mm]; an estimate is enough
};

/// The time offset of a sensor that passes over the same ground in opposite directions: over an edge there
/// and back, or in overlapping swaths. The two passes show an edge at two places that are apart by twice the
/// speed times the offset. Passes are found in the motion, as straight and level pieces at the usual speed
/// along which the sensor sees something. So a print with scan passes is enough. A sensor whose line is
/// turned about the viewing direction (`skew_deg`) also shifts overlapping swaths against each other; if a
/// swath has a neighbour on its left and one on its right, the two shifts cancel.
///
/// @throws InvalidInput if there are no two passes in opposite directions that see the same ground, the
///   ground is too even to show an offset, or the best offset lies at the end of the search
TimeOffset offsetByPasses(const SensorRecording& recording, const PassComparison& comparison);

}  // namespace lamina
