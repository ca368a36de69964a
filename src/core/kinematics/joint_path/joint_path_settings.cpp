// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"

namespace lamina {

namespace {

void describeYaw(SettingsSchema& schema, JointPathSettings& settings) {
  schema.choice<YawChoice>(
      "joints.yaw", settings.yaw, {{"free", YawChoice::Free}, {"held", YawChoice::Held}},
      "Whether the turn of the nozzle about its tool axis is chosen or held as the toolpath "
      "has it.");
  schema.integer("joints.yaw_samples", settings.yaw_samples, {1, 360},
                 "Turns about the tool axis that are looked at.");
  schema.integer(
      "joints.yaw_reach", settings.yaw_reach, {0, 180},
      "Samples by which the turn about the tool axis may change from a waypoint to the next, at most.");
  schema.number("joints.yaw_weight", settings.yaw_weight, {0.0, 1000.0},
                "What turning about the tool axis costs; a joint costs 1 over its greatest speed, squared.");
  schema.flag("joints.smooth_yaw", settings.is_yaw_smoothed,
              "Whether the turn about the tool axis is smoothed after the samples are chosen.");
  schema.integer("joints.redundancy_samples", settings.redundancy_samples, {1, 36},
                 "Arm angles of an arm of seven axes that are looked at; 1 holds it at 0.");
}

void describeSingularities(SettingsSchema& schema, JointPathSettings& settings) {
  schema.number("joints.singular_margin_deg", settings.singular_margin_deg, {0.0, 90.0},
                "Angle from a singularity below which places are avoided.");
  schema.number("joints.singular_weight", settings.singular_weight, {0.0, 1e6},
                "What a second in a singularity costs.");
  schema.number("joints.least_margin_deg", settings.least_margin_deg, {0.0, 90.0},
                "Angle from a singularity below which a waypoint cannot be run.");
  schema.number(
      "joints.singular_tool_axis_tolerance_deg", settings.singular_tool_axis_tolerance_deg, {0.0, 20.0},
      "Angle by which the tool axis may leave the toolpath's so that a machine passes a singularity.");
  schema.renamed("joints.singular_jet_tolerance_deg", "joints.singular_tool_axis_tolerance_deg");
  schema.number("joints.swing_tolerance_deg", settings.swing_tolerance_deg, {0.0, 20.0},
                "Angle by which the tool axis may leave the toolpath's so that a rotary joint of a machine "
                "swings less.");
  schema.number("joints.max_slowdown", settings.max_slowdown, {1.0, 1e6},
                "How many times longer than at its feed a motion near a singularity may take, at most.");
}

void describeExternal(SettingsSchema& schema, JointPathSettings& settings) {
  schema.choice<ExternalChoice>(
      "joints.external", settings.external,
      {{"held", ExternalChoice::Held},
       {"follow", ExternalChoice::Follow},
       {"gravity", ExternalChoice::Gravity}},
      "Whether the table of an arm is held, turned with the tool axis, or tilted and "
      "turned so that the tool axis points down.");
  schema.number("joints.external_deg", settings.external_deg, {-3600.0, 3600.0},
                "Where rotary external axes are held, or where the table starts to turn.");
  schema.number(
      "joints.external_azimuth_deg", settings.external_azimuth_deg, {-180.0, 180.0},
      "Direction over the table, from away from the robot, in which tool axes go if the table follows.");
  schema.number(
      "joints.external_cone_deg", settings.external_cone_deg, {0.1, 90.0},
      "How far from straight down the tool axis may point so that a table that it is kept down by turns "
      "steadily.");
  schema.choice<RailChoice>(
      "joints.rail", settings.rail,
      {{"held", RailChoice::Held}, {"follow", RailChoice::Follow}, {"steps", RailChoice::Steps}},
      "Whether the rail of an arm is held at zero, moved steadily with the tip, or moved on travels only.");
}

}  // namespace

void describe(SettingsSchema& schema, JointPathSettings& settings) {
  describeYaw(schema, settings);
  schema.number("joints.max_turn_deg", settings.max_turn_deg, Bounds::above(0.0, 360.0),
                "Turn of a joint in one motion, other than a travel, above which it is a jump.");
  schema.choice<BranchChange>("joints.branch_change", settings.branch_change,
                              {{"travel", BranchChange::OnTravel}, {"never", BranchChange::Never}},
                              "Where the kinematic model may go over to another of its branches.");
  schema.number("joints.branch_change_cost", settings.branch_change_cost, {0.0, 1e6},
                "What a change of branch costs.");
  schema.number("joints.limit_margin_deg", settings.limit_margin_deg, {0.0, 90.0},
                "Angle of a joint from its limit below which places are avoided.");
  schema.number("joints.limit_weight", settings.limit_weight, {0.0, 1e6},
                "What a second at the limit of a joint costs.");
  describeSingularities(schema, settings);
  describe(schema, settings.division);
  describeExternal(schema, settings);
}

void validate(const JointPathSettings& settings) {
  JointPathSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
}

}  // namespace lamina
