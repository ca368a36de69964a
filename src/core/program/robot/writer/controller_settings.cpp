// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/writer/controller_settings.hpp"

#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/arm/arm_controller.hpp"
#include "program/robot/robot_cell.hpp"

namespace lamina {
namespace {

template <class Value>
void takeFromCell(Value& setting, const Value& by_default, const Value& stated, const char* key) {
  if (setting != by_default && setting != stated)
    throw InvalidConfig(std::string(key) +
                        " differs from what cell.controller states; expected one of them, or both alike");
  setting = stated;
}

}  // namespace

RobotProgramSettings withArmController(RobotProgramSettings settings, RobotLanguage language,
                                       const KinematicModel& arm) {
  requireControllerKind(arm.urdf(), controllerKind(language), toString(language));
  const std::optional<ArmController> cell = armController(arm.urdf());
  if (!cell) return settings;
  const RobotProgramSettings plain;
  if (!cell->signs.empty())
    takeFromCell(settings.joint_signs, plain.joint_signs, cell->signs, "robot_program.joint_signs");
  if (!cell->zeros_deg.empty())
    takeFromCell(settings.joint_zeros_deg, plain.joint_zeros_deg, cell->zeros_deg,
                 "robot_program.joint_zeros_deg");
  if (cell->joint_3_from_2)
    takeFromCell(settings.fanuc.joint_3_from_2, plain.fanuc.joint_3_from_2, *cell->joint_3_from_2,
                 "fanuc.joint_3_from_2");
  if (cell->tool_number)
    takeFromCell(settings.tool_number, plain.tool_number, *cell->tool_number, "robot_program.tool_number");
  if (cell->frame_number)
    takeFromCell(settings.frame_number, plain.frame_number, *cell->frame_number,
                 "robot_program.frame_number");
  return settings;
}

}  // namespace lamina
