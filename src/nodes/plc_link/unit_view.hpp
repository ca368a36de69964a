// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "lamina/modbus/register_map.hpp"
#include "messages.hpp"

namespace lamina {

/// What the nodes of a cell have said last, as far as the PLC's registers have a place for it.
struct UnitView {
  lamina_msgs::PackmlStatus unit;
  lamina_msgs::CellAlarms alarms;
  lamina_msgs::JobQueue queue;
  lamina_msgs::MachineState machine;
  lamina_msgs::HeaterState heaters;
  lamina_msgs::ProcessState process;
  lamina_msgs::PrintProgress printed;
  lamina_msgs::LoopState loop;
  lamina_msgs::LayerHeight layer;
  lamina_msgs::LoopFigures figures;                ///< of the layer measured last, by the loop
  std::map<std::string, double> mean_corrections;  ///< of maps by their digest
  double unit_heard_s = 0.0;                       ///< when the unit's status came
  double process_heard_s = 0.0;                    ///< and what the process does
  double printed_heard_s = 0.0;                    ///< and how much of the job is printed
  double heaters_heard_s = 0.0;  ///< and the temperatures, ten times a second as long as a job or a step runs
};

/// Mean of a map's relative amounts by the length of what they correct; 0 for an empty one.
double meanCorrection(const lamina_msgs::CorrectionMap& map);

/// The same for the registers. What nobody says is 0.
/// @param now_s  by the clock of the times in @p view
PlcStatus plcStatus(const UnitView& view, double now_s);

}  // namespace lamina
