// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/program/rapid/rapid_settings.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"
#include "program/program_stations.hpp"
#include "program/rapid/writer/rapid_lines.hpp"
#include "program/rapid/writer/rapid_plan.hpp"

namespace lamina {

/// Procedures by which an arm approaches the part and retracts from it.
struct RapidPassages {
  std::string procedures;  ///< text of both procedures, with their notes; empty without an arm
  std::string to_part;     ///< the statements in main that call the approach
  std::string from_part;
  bool is_wrist_singular = false;  ///< whether joint 5 comes within 2 deg of where axes 4 and 6 are in line
};

/// The settings with tool and work object completed from the arm's description, where they leave them open:
/// both frames, and STN1 as the mechanical unit if an external axis carries the bed.
/// @throws InvalidConfig as `armCell`
RapidSettings withArmCell(RapidSettings settings, const KinematicModel& arm);

/// Plans an approach by MoveAbsJ to joints from which the tool moves along its axis to the first pose, and a
/// retract along the tool axis from the last pose.
/// @param air_speed  name of the speed in air
/// @throws Unreachable if the arm cannot reach the pose at which the approach begins
RapidPassages rapidPassages(const RobotMotion& robot, const ProgramStations& stations, const RapidPlan& plan,
                            const std::string& air_speed, const RapidSettings& settings);

}  // namespace lamina
