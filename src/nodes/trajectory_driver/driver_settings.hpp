// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "dry_order.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/toolpath/resume_place.hpp"
#include "lamina/trajectory/approach.hpp"
#include "lamina/trajectory/jog_settings.hpp"
#include "lamina/trajectory/trajectory_feeder_settings.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// How silence of a controller is detected: by the arrival of reports, or by their stamps if the controller's
/// clock is not the wall clock, as with a simulated one on a slow host.
enum class SilenceBy : std::uint8_t { Arrival, Stamps };

/// Limits beyond which a driver gives up.
struct TrackingLimits {
  double tip_mm = 5.0;     ///< distance of the tip from its planned position; 0 for no limit
  double silence_s = 1.0;  ///< time without a report of the controller
  SilenceBy silence_by = SilenceBy::Arrival;
};

/// What the driver requires of process_io.
struct ProcessIoDemand {
  bool is_required = false;  ///< without it nothing is driven
  double silence_s = 1.0;    ///< silence of process_io that holds the job
};

struct DriverSettings {
  MachineSettings machine;
  std::string owner;           ///< the only node whose orders are followed; empty for any node
  double owner_grace_s = 0.0;  ///< time without the ordering cell until the job is held; 0 for no limit
  std::string guard_socket;  ///< of the watch that stops the controller in this node's place; empty for none
  RunSettings run;
  TrajectoryFeederSettings feeder;
  bool is_clearance_checked = true;  ///< before the first motion
  ClearanceSettings clearance;
  TrackingLimits tracking;
  ApproachSettings approach;
  ToolpathResumeSettings resume;
  ProcessIoDemand process_io;
  DrySettings dry;
  JogSettings jog;
  bool is_corrected = false;      ///< by the maps on the topic correction
  bool follows_plans = false;     ///< goes on with layers planned anew
  LoopSettings loop;              ///< settings of `describeFeeding` and of the wait for maps are used
  std::string calibration;        ///< file of results; empty for none
  double start_delay_s = 0.5;     ///< from the first chunk to its first point
  double lift_mm = 10.0;          ///< of the tool after an abort
  double lift_mm_s = 10.0;        ///< speed of that lift
  double controller_wait_s = 60;  ///< for the toolpath, the controller and the joints' positions to be there
};

/// Adds the keys machine.*, executor.owner, owner.grace_s, guard.socket, joints.*, motion.*, trajectory.*,
/// process.*, feeder.*, clearance.*, tracking.*, approach.*, resume.*, process_io.*, dry.*, jog.*,
/// corrections.*, sensor.calibration, some of loop.*, check_clearance, start_delay_s, lift_mm, lift_mm_s and
/// controller_wait_s.
void describe(SettingsSchema& schema, DriverSettings& settings);

}  // namespace lamina
