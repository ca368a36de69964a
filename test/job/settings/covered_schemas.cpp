// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings/covered_schemas.hpp"

#include <algorithm>

#include "job/settings/setting_probe.hpp"
#include "lamina/calibration/calibration_settings.hpp"
#include "lamina/calibration/flow_trial.hpp"
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
                   ResumeSettings, CalibrationSettings, FlowTrialSettings>();
}

const std::vector<TestedElsewhere>& testedElsewhere() {
  static const std::vector<TestedElsewhere> all = {
      {"clearance.report", "ros/slicing/slicing_service_test.cpp", "clearance.report"},
      {"overhang.report", "ros/slicing/slicing_service_test.cpp", "overhang.report"},
      {"frames.every_mm", "ros/settings/shown_probes.cpp", "{\"frames.every_mm="},
      {"frames.length_mm", "ros/settings/shown_probes.cpp", "{\"frames.length_mm="}};
  return all;
}

}  // namespace lamina::test
