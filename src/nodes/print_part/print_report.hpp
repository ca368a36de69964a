// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "messages.hpp"

namespace lamina {

/// Results of a finished print.
struct PrintReport {
  std::string part;
  std::string toolpath_id;
  lamina_msgs::SliceSummary slicing;
  lamina_msgs::StreamProgramResult streaming;
  std::vector<lamina_msgs::LayerHeight> layers;  ///< in the order of their reports; seen or not
  std::vector<std::size_t> unreported;           ///< layers with a scan pass but without a report
  lamina_msgs::ProfileCounts counts;             ///< of all profiles at the end
  bool has_everything = true;  ///< whether the monitor has all up to the machine's last stamp
  double wall_time_s = 0.0;    ///< from the request to the last measurement
};

/// Measured less expected height over all layers that were seen, each weighted by the cells seen.
struct HeightError {
  double mean_mm = 0.0;
  double worst_mm = 0.0;  ///< of the largest magnitude, with its sign
  double coverage = 0.0;  ///< mean over the layers
  std::size_t layers = 0;
};

/// All zero if no layer was seen.
HeightError heightError(const std::vector<lamina_msgs::LayerHeight>& layers);

/// Layers with a scan pass, ascending.
/// @param clearance_mm  clearance with which the scan passes are planned
std::vector<std::size_t> scannedLayers(const Toolpath& toolpath, double clearance_mm);

/// Layers that should have been seen and were not, ascending.
std::vector<std::size_t> layersNotSeen(const PrintReport& report);

/// Why the measurement of the part is incomplete: names layers that were not seen or cut short; empty if it
/// is complete.
std::string measurementFault(const PrintReport& report);

/// How many profiles could not be placed, and why; empty if there are none.
std::string unplacedText(const lamina_msgs::ProfileCounts& counts);

/// The report as a person reads it: layers, lengths, lines, resends, height errors, times.
std::string summaryText(const PrintReport& report);

}  // namespace lamina
