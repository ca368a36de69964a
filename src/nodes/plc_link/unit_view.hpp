// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "lamina/modbus/register_map.hpp"
#include "messages.hpp"

namespace lamina {

/// The last messages of a cell's nodes, as far as the PLC's registers show them.
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
  std::map<std::string, double> mean_corrections;  ///< mean correction of each map, by its digest
  double unit_heard_s = 0.0;                       ///< when the unit's status came
  double process_heard_s = 0.0;                    ///< when the state of the process came
  double printed_heard_s = 0.0;                    ///< when the printed length and material came
  double heaters_heard_s = 0.0;  ///< when the temperatures came, ten times a second during a job or step
};

/// Mean of a map's relative amounts, weighted by the corrected lengths; 0 for an empty map.
double meanCorrection(const lamina_msgs::CorrectionMap& map);

/// The view as register values. Values that no node reports are 0.
/// @param now_s  by the clock of the times in @p view
PlcStatus plcStatus(const UnitView& view, double now_s);

}  // namespace lamina
