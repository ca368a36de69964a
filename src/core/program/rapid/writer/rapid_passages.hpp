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

/// How an arm comes to the part and leaves it.
struct RapidPassages {
  std::string procedures;  ///< both of them, with their notes; empty without an arm
  std::string to_part;     ///< the calls in main
  std::string from_part;
  bool is_wrist_singular = false;  ///< somewhere joint 5 comes within 2 deg of where axes 4 and 6 are in line
};

/// What the settings leave open of tool and work object, from the arm's description: both frames, and STN1 as
/// the mechanical unit where an external axis carries the bed.
/// @throws InvalidConfig as `armCell`
RapidSettings withArmCell(RapidSettings settings, const KinematicModel& arm);

/// An approach by MoveAbsJ to joints from which the tool goes along its axis to the first pose, and a retract
/// along it from the last.
/// @param air_speed  its name
/// @throws Unreachable if the arm cannot stand where it is to start
RapidPassages rapidPassages(const RobotMotion& robot, const ProgramStations& stations, const RapidPlan& plan,
                            const std::string& air_speed, const RapidSettings& settings);

}  // namespace lamina
