// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "journal_care.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/cell/plc_watch.hpp"
#include "lamina/cell/queue_follower.hpp"
#include "lamina/job/drivable_toolpath.hpp"
#include "lamina/kinematics/machine_choice.hpp"

namespace lamina {

/// The node that runs a cell's jobs.
enum class ExecutorKind : std::uint8_t {
  Stream,  ///< gcode_streamer: programs of G-code
  Driver,  ///< trajectory_driver: toolpaths (.csv)
};

/// Parameters of the node cell_controller.
struct CellControllerSettings {
  MachineSettings machine;
  ExecutorKind executor = ExecutorKind::Stream;
  Placement placement = Placement::Centre;  ///< of toolpaths on the bed
  DriveCheckSettings drive;                 ///< settings of the check of toolpaths
  std::string folder = "cell";              ///< of journal and files
  double patience_s = 2.0;                  ///< for the executor: at the start, and for each order
  std::string corrections_folder;           ///< of the streamer; empty for none
  bool is_held_on_the_way = true;           ///< Hold is accepted in transitions to and from Execute
  bool is_start_local_after_stop =
      true;                 ///< the first Start after an emergency stop does not come from the PLC
  bool needs_loop = false;  ///< jobs start only with a height loop that may run, and clocks that agree
  QueueAdvance advance = QueueAdvance::Ask;  ///< what begins the next job once a part is complete
  PlcWatchSettings plc;
  JournalCareSettings care;
};

/// Adds the node's keys.
void describe(SettingsSchema& schema, CellControllerSettings& settings);

/// Whether, after this alarm of the PLC, the next Start must not come from the PLC.
bool demandsLocalStart(const PlcAlarm& alarm, const CellControllerSettings& settings);

}  // namespace lamina
