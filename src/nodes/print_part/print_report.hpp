// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "messages.hpp"

namespace lamina {

/// What is known of a part once it is printed.
struct PrintReport {
  std::string part;
  std::string toolpath_id;
  lamina_msgs::SliceSummary slicing;
  lamina_msgs::StreamProgramResult streaming;
  std::vector<lamina_msgs::LayerHeight> layers;  ///< measured, in the order they were measured
  double wall_time_s = 0.0;                      ///< from the request to the last measurement
};

/// Measured less expected height over all layers, each weighted by the cells seen.
struct HeightError {
  double mean_mm = 0.0;
  double worst_mm = 0.0;  ///< of the largest magnitude, with its sign
  double coverage = 0.0;  ///< mean over the layers
};

/// All zero if no layer was measured.
HeightError heightError(const std::vector<lamina_msgs::LayerHeight>& layers);

/// The report as a person reads it: layers, lengths, lines, resends, height errors, times.
std::string summaryText(const PrintReport& report);

}  // namespace lamina
