// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// How late the sensor's stamps are: what it saw at a stamp was there at stamp - offset.
struct TimeOffset {
  double offset_s = 0.0;
  double spread_s = 0.0;         ///< standard deviation of the offset
  double scatter_s = 0.0;        ///< standard deviation from piece to piece; 0 of a single piece
  double drift_s_per_min = 0.0;  ///< slope of the pieces over time; 0 of fewer than three
  double agreement = 0.0;        ///< correlation, 1 at best
  std::size_t profiles = 0;      ///< that were used
  std::vector<double> pieces_s;  ///< offset by each piece: a tenth of the bobbing, or a pair of passes
  double skew_deg = 0.0;         ///< by which passes seem to see the line turned about the viewing direction
  bool is_skew_known = false;    ///< whether passes lay on either side of each other, so that it cancels
};

/// The time offset of a sensor that bobs over a flat place: the lag at which the mean depth of the profiles
/// agrees best with the nozzle's height, each less its mean over 2 s. Lags are tried every millisecond, and
/// the best one is refined by a parabola. The place of the sensor need not be known; it must look along the
/// nozzle.
///
/// @param search_s  greatest offset looked for, either way; positive
/// @throws InvalidInput if the recording is shorter than 4 s or longer than 600 s, the nozzle moves less than
///   0.05 mm rms, profiles do not follow it (correlation below 0.8), the best lag lies at the end of the
///   search, or another one is as good because the motion repeats itself
TimeOffset offsetByBobbing(const SensorRecording& recording, double search_s);

/// How passes in opposite senses are compared.
struct PassComparison {
  double search_s = 0.6;   ///< greatest offset looked for, either way; positive
  double column_mm = 0.5;  ///< width of the strips across the travel in which heights are compared
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();  ///< about [mm]
};

/// The time offset of a sensor that passes over the same ground in opposite senses: over an edge there and
/// back, or in overlapping swaths. The two passes see an edge at places that are apart by twice the speed
/// times the offset. Passes are found in the motion, as straight and level pieces at the usual speed along
/// which the sensor sees something. So a print with scan passes is enough. A sensor whose line is turned
/// about its viewing direction shifts overlapping swaths too. This cancels between neighbours to the left
/// and to the right.
///
/// @throws InvalidInput if there are no two passes in opposite senses that see the same ground, it is too
///   even to show an offset, or the best offset lies at the end of the search
TimeOffset offsetByPasses(const SensorRecording& recording, const PassComparison& comparison);

}  // namespace lamina
