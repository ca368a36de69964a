// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings/covered_schemas.hpp"

#include <algorithm>

#include "job/settings/setting_probe.hpp"
#include "lamina/calibration/calibration_settings.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/deposition/growth_plant.hpp"
#include "lamina/deposition/path_follower.hpp"
#include "lamina/dynamics/tracking_simulation.hpp"
#include "lamina/job/incline_settings.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/monitoring/height_monitor.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "lamina/scaffold/scaffold_settings.hpp"
#include "lamina/startup/startup_settings.hpp"
#include "lamina/streaming/emulator/emulated_settings.hpp"
#include "lamina/streaming/job/stream_settings.hpp"
#include "lamina/streaming/resume/remaining_program.hpp"
#include "lamina/study/search_settings.hpp"
#include "lamina/trajectory/approach.hpp"
#include "lamina/trajectory/simulated_controller.hpp"
#include "lamina/trajectory/trajectory_feeder_settings.hpp"

namespace lamina::test {
namespace {

template <class... Settings>
std::vector<std::string> keysOfAll() {
  std::vector<std::string> all;
  for (const auto& keys : {keysOf<Settings>()...}) all.insert(all.end(), keys.begin(), keys.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

std::vector<std::string> coreKeys() {
  return keysOfAll<JobSettings, InclineSettings, RunSettings, SearchSettings, KrigingSettings,
                   ScaffoldSettings, StartupSettings, StreamSettings, EmulatedSettings, ApproachSettings,
                   TrajectoryFeederSettings, ServoSettings, FollowingSettings, MonitorSettings,
                   ProfileSensorSettings, TrackingSettings, LoopSettings, PlantSettings, SightSettings,
                   ResumeSettings, CalibrationSettings>();
}

const std::vector<TestedElsewhere>& testedElsewhere() {
  static const std::vector<TestedElsewhere> all = {
      {"clearance.need", "job/joint_program_test.cpp", "clearance.need"},
      {"clearance.raise_tool_axis", "job/joint_program_test.cpp", "raises_tool_axis"},
      {"clearance.report", "ros/slicing/slicing_service_test.cpp", "clearance.report"},
      {"drop_voids.least_share", "job/voids/drop_void_job_test.cpp", "least_share"},
      {"stream.firmware", "streaming/firmware/firmware_protocol_test.cpp", "stream.firmware"},
      {"stream.password_file", "streaming/session/upload_session_test.cpp", "password_file"},
      {"frames.every_mm", "ros/adapters/frame_markers_test.cpp", "every_mm"},
      {"frames.length_mm", "ros/adapters/frame_markers_test.cpp", "length_mm"},
      {"fanuc.name_length", "program/robot/robot_writer_test.cpp", "fanuc.name_length"},
      {"inform.name_length", "program/robot/robot_writer_test.cpp", "inform.name_length"},
      {"krl.max_mb", "program/robot/robot_writer_test.cpp", "max_mb"},
      {"robot_program.allow_cut", "program/robot/robot_writer_test.cpp", "may_cut"},
      {"input.deflection_deg", "geometry/mesh_io/step_reader_test.cpp", "deflection"},
      {"input.deflection_mm", "geometry/mesh_io/step_reader_test.cpp", "deflection_mm"},
      {"input.extrude_mm", "job/part/outline_part_test.cpp", "extrude_mm"},
      {"machine.greatest_bed_c", "job/profiles/capabilities_test.cpp", "machine.greatest_bed_c"},
      {"machine.greatest_layer_mm", "job/profiles/capabilities_test.cpp", "machine.greatest_layer_mm"},
      {"machine.greatest_nozzle_c", "job/profiles/capabilities_test.cpp", "machine.greatest_nozzle_c"},
      {"machine.has_bed_heater", "job/profiles/capabilities_test.cpp", "machine.has_bed_heater"},
      {"machine.has_fan", "job/profiles/capabilities_test.cpp", "machine.has_fan"},
      {"machine.least_layer_mm", "job/profiles/capabilities_test.cpp", "machine.least_layer_mm"},
      {"machine.nozzle_mm", "job/profiles/capabilities_test.cpp", "machine.nozzle_mm"},
      {"joints.branch_change", "kinematics/joint_path/joint_path_planner_test.cpp", "branch_change"},
      {"joints.branch_change_cost", "kinematics/joint_path/ladder_search_test.cpp", "branch_change_cost"},
      {"joints.max_slowdown", "kinematics/joint_path/joint_path_planner_test.cpp", "max_slowdown"},
      {"overhang.report", "ros/slicing/slicing_service_test.cpp", "overhang.report"},
      {"pose_gap_mm", "monitoring/stamped_heights_test.cpp", "pose_gap_mm"},
      {"quiet_s", "monitoring/stamped_heights_test.cpp", "quiet_s"},
      {"tool.interface", "planning/tools/tool_settings_test.cpp", "interface"},
      {"tool.support", "planning/tools/tool_settings_test.cpp", "support"},
      {"raster.order", "infill/rectilinear/section_order_test.cpp", "tourByEnds"},
      {"sweep.cut_height", "sweep/sweep_test.cpp", "CutHeight::Absolute"},
      {"surrogate.answer_nearness", "job/study/study_job_test.cpp", "answer_nearness"}};
  return all;
}

}  // namespace lamina::test
