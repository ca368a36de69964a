// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "action_executor.hpp"
#include "lamina/job/part/placement.hpp"
#include "messages.hpp"
#include "resume/resume_look.hpp"

namespace lamina {

/// The node trajectory_driver as the cell's executor: its jobs are toolpaths (.csv). An interrupted job is
/// resumed on the bead at which the machine came to rest.
class DriverExecutor final : public ActionExecutor<lamina_msgs::DriveToolpathAction> {
 public:
  /// @param placement  of jobs on the bed
  /// @param report  receives the executor's reports
  DriverExecutor(const ros::NodeHandle& node, Placement placement,
                 std::function<void(const ExecutorReport&)> report);

  ExecutorTraits traits() const override;
  void lookAtResume(const std::string& program, const ExecutionProgress& progress) override;
  ResumeOutlook resumeOutlook() const override;
  void confirmPlace(std::optional<double> begin_mm) override;

 protected:
  lamina_msgs::DriveToolpathGoal goalOf(const StartOrder& order) const override;
  std::uint64_t takenThrough(const lamina_msgs::DriveToolpathResult& result) const override;

 private:
  Placement placement_;
  ros::ServiceClient place_;
  ResumeLook look_;
  std::optional<double> confirmed_mm_;  ///< as in `confirmPlace`
  // Last, so that it ends before what it uses.
  OrderThread looks_;
};

}  // namespace lamina
