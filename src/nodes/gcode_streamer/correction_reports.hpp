// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <string>

#include "corrected_stream.hpp"
#include "messages.hpp"
#include "recorded_program.hpp"

namespace lamina {

/// Reports the outcome of corrections to the loop and to the log.
class CorrectionReports {
 public:
  /// Reports nothing.
  CorrectionReports() = default;
  explicit CorrectionReports(ros::NodeHandle& node);

  /// Reports the layers that were decided since the last call.
  void tell(CorrectedStream& corrected) const;
  /// Reports layers that are deposited as planned in a job resumed from its record, as they come: without a
  /// report the loop assumes that they are deposited by its maps.
  void tell(RecordedProgram& recorded, std::int32_t layer) const;
  /// Reports that a plan is not followed: the loop then gives the plan's first layer a map, and continues
  /// from what is deposited.
  void refuse(const std::string& plan_id, const CorrectedStream& corrected, const std::string& reason) const;

 private:
  void publish(lamina_msgs::AppliedCorrection message) const;

  ros::Publisher applied_;
};

}  // namespace lamina
