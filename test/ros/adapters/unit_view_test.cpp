// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/plc_link/unit_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lamina {
namespace {

bool hasFlag(const PlcStatus& status, StatusFlag flag) {
  return std::count(status.flags.begin(), status.flags.end(), flag) == 1;
}

UnitView printing() {
  UnitView view;
  view.unit.state = 6;
  view.unit.mode = 1;
  view.unit.job.id = 70;
  view.unit.job.name = "bracket";
  view.unit.job.state = 3;
  view.unit.layer = 4;
  view.unit.layers = 12;
  view.unit.fraction = 0.25;
  view.unit.elapsed = 61.9;
  view.unit.remaining = -1.0;
  view.unit.in_state = 10.0;
  view.unit.in_mode = 100.0;
  view.unit.since_reset = 1000.0;
  view.unit.parts = 3;
  view.unit_heard_s = view.heaters_heard_s = 50.0;
  view.machine.state = lamina_msgs::MachineState::EXECUTE;
  view.machine.state_name = "Execute";
  view.heaters.nozzle = 210.5;
  view.heaters.nozzle_target = 210.0;
  view.heaters.bed = view.heaters.bed_target = std::numeric_limits<double>::quiet_NaN();
  return view;
}

TEST(UnitView, ShowsAUnitThatPrints) {
  const PlcStatus status = plcStatus(printing(), 50.5);
  EXPECT_EQ(status.state, UnitState::Execute);
  EXPECT_EQ(status.state_requested, UnitState::Execute);
  EXPECT_EQ(status.job.id, 70U);
  EXPECT_EQ(status.job.layers, 12);
  EXPECT_EQ(status.job.gone_s, 61U);
  EXPECT_EQ(status.job.left_s, 4294967295U) << "not known";
  EXPECT_DOUBLE_EQ(status.in_state_s, 10.5);
  EXPECT_DOUBLE_EQ(totalTime(status.counters), 1000.5);
  EXPECT_EQ(status.counters.parts, 3U);
  EXPECT_FLOAT_EQ(status.process.nozzle_c, 210.5F);
  EXPECT_EQ(status.process.bed_c, 0.0F) << "a machine without one";
  EXPECT_TRUE(hasFlag(status, StatusFlag::JobLoaded));
  EXPECT_TRUE(hasFlag(status, StatusFlag::HeatersOn));
  EXPECT_TRUE(hasFlag(status, StatusFlag::Motion));
  EXPECT_TRUE(hasFlag(status, StatusFlag::StartupDone)) << "it has none";
  EXPECT_FALSE(hasFlag(status, StatusFlag::StateChanging));
  EXPECT_FALSE(hasFlag(status, StatusFlag::PartOnPlate));
}

TEST(UnitView, ShowsWhatIsPrintedAndHowFast) {
  UnitView view = printing();
  view.unit.laid_length = 1.5;
  view.printed.tip_speed = 0.03;
  view.printed_heard_s = 50.0;
  EXPECT_FLOAT_EQ(plcStatus(view, 50.5).job.path_mm, 1500.0F);
  EXPECT_FLOAT_EQ(plcStatus(view, 50.5).process.tip_speed_mm_s, 30.0F);
  EXPECT_EQ(plcStatus(view, 51.1).process.tip_speed_mm_s, 0.0F) << "the job has ended";
  view.printed.tip_speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plcStatus(view, 50.5).process.tip_speed_mm_s, 0.0F);
}

TEST(UnitView, ShowsWhatStopsAndWaits) {
  UnitView view = printing();
  view.unit.state = 10;
  view.unit.remaining = 12.9;
  view.unit.stop_reason = 3202;
  view.unit.stop_value = -20.4;
  view.unit.is_part_on_plate = view.unit.resume_waits = 1;
  view.machine.state = lamina_msgs::MachineState::HELD;
  view.machine.startup.resize(1);
  view.machine.startup[0].state = lamina_msgs::StartupStep::RUNNING;
  view.alarms.alarms.resize(2);
  view.alarms.alarms[0].id = 3202;
  view.alarms.alarms[0].category = "H";
  view.alarms.alarms[0].value = 20.0;
  view.alarms.alarms[1].category = "W";
  view.queue.jobs.resize(3);
  view.queue.jobs[0].state = 1;
  view.queue.jobs[1].state = 2;
  view.queue.jobs[2].state = 3;
  const PlcStatus status = plcStatus(view, 50.0);
  EXPECT_EQ(status.state_requested, UnitState::Held);
  EXPECT_EQ(status.job.left_s, 12U);
  EXPECT_EQ(status.job.queued, 2) << "the third runs";
  EXPECT_EQ(status.stop_reason, 3202);
  EXPECT_EQ(status.stop_value, -20);
  ASSERT_EQ(status.alarms.size(), 2U);
  EXPECT_EQ(status.alarms[0].category, AlarmCategory::Hold);
  for (const StatusFlag flag : {StatusFlag::StateChanging, StatusFlag::Alarm, StatusFlag::Warning,
                                StatusFlag::PartOnPlate, StatusFlag::ResumeWaits})
    EXPECT_TRUE(hasFlag(status, flag)) << static_cast<int>(flag);
  EXPECT_FALSE(hasFlag(status, StatusFlag::Motion));
  EXPECT_FALSE(hasFlag(status, StatusFlag::StartupDone));
}

TEST(UnitView, NamesTheJobThatStartWouldBegin) {
  UnitView view = printing();
  EXPECT_EQ(plcStatus(view, 50.0).job.next, 0U) << "the queue is empty";
  view.queue.jobs.resize(4);
  for (std::size_t i = 0; i < view.queue.jobs.size(); ++i)
    view.queue.jobs[i].id = static_cast<std::uint32_t>(70 + i);
  view.queue.jobs[0].state = 3;  // it runs
  view.queue.jobs[1].state = 1;  // not released yet
  view.queue.jobs[2].state = view.queue.jobs[3].state = 2;
  EXPECT_EQ(plcStatus(view, 50.0).job.next, 72U);
  view.unit.resume_waits = 1;
  EXPECT_EQ(plcStatus(view, 50.0).job.next, 0U) << "what was cut off is decided on first, and not by the PLC";
}

TEST(UnitView, ShowsLaserAndWireWhileTheProcessIsHeard) {
  UnitView view = printing();
  view.process_heard_s = 50.0;
  view.process.flow = 12e-9;
  view.process.laser_power = 1850.0;
  view.process.wire_speed = 0.025;
  const ProcessFigures now = plcStatus(view, 50.9).process;
  EXPECT_FLOAT_EQ(now.flow_mm3_s, 12.0F);
  EXPECT_FLOAT_EQ(now.laser_w, 1850.0F);
  EXPECT_FLOAT_EQ(now.wire_mm_s, 25.0F);
  EXPECT_EQ(plcStatus(view, 51.1).process.laser_w, 0.0F) << "silent for more than a second";
  view.process.laser_power = view.process.wire_speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plcStatus(view, 50.9).process.laser_w, 0.0F) << "a process without one";
  EXPECT_EQ(plcStatus(view, 50.9).process.wire_mm_s, 0.0F);
}

// 3 mm at +0.1 and 1 mm at -0.1: (0.3 - 0.1) / 4.
TEST(UnitView, ShowsTheMeanCorrectionOfTheLayerThatWasMeasured) {
  lamina_msgs::CorrectionMap map;
  map.paths.resize(2);
  map.paths[0].station = 1.5e-3;
  map.paths[0].amount = {0.1, 0.1};
  map.paths[1].station = 1e-3;
  map.paths[1].amount = {-0.1};
  EXPECT_NEAR(meanCorrection(map), 0.05, 1e-12);
  EXPECT_EQ(meanCorrection({}), 0.0);
  UnitView view = printing();
  view.layer.toolpath_id = view.figures.toolpath_id = "a";
  view.layer.layer = view.figures.layer = 3;
  view.figures.map_digest = "0123456789abcdef";
  view.mean_corrections["0123456789abcdef"] = 0.05;
  EXPECT_FLOAT_EQ(plcStatus(view, 50.0).process.mean_correction, 0.05F);
  view.figures.layer = 2;
  EXPECT_EQ(plcStatus(view, 50.0).process.mean_correction, 0.0F) << "of the layer before";
  view.figures.layer = 3;
  view.figures.map_digest = "";
  EXPECT_EQ(plcStatus(view, 50.0).process.mean_correction, 0.0F) << "as planned";
}

// The streamer says nothing of the heaters once its job has ended: they cool, or are heated by somebody else.
TEST(UnitView, ShowsNoTemperaturesOfAJobThatHasEnded) {
  const UnitView view = printing();
  EXPECT_FLOAT_EQ(plcStatus(view, 51.9).process.nozzle_c, 210.5F);
  const PlcStatus later = plcStatus(view, 52.1);
  EXPECT_EQ(later.process.nozzle_c, 0.0F);
  EXPECT_TRUE(hasFlag(later, StatusFlag::HeatersOn)) << "nobody has said that they were switched off";
  EXPECT_EQ(plcStatus(UnitView(), 1.0).process.nozzle_c, 0.0F);
}

TEST(UnitView, ShowsProcessAndLoopWhileTheySpeak) {
  UnitView view = printing();
  view.process.flow = 2e-9;
  view.process.laser = 1;
  view.process_heard_s = 50.0;
  view.loop.state = lamina_msgs::LoopState::COASTING;
  view.layer.mean_error = -2e-5;
  view.layer.rms_error = 3e-5;
  view.layer.coverage = 0.9;
  const PlcStatus status = plcStatus(view, 50.9);
  EXPECT_FLOAT_EQ(status.process.flow_mm3_s, 2.0F);
  EXPECT_FLOAT_EQ(status.process.mean_error_mm, -0.02F);
  EXPECT_FLOAT_EQ(status.process.rmse_mm, 0.03F);
  EXPECT_FLOAT_EQ(status.process.coverage, 0.9F);
  EXPECT_TRUE(hasFlag(status, StatusFlag::BeamOn));
  EXPECT_TRUE(hasFlag(status, StatusFlag::LoopCoasting));
  EXPECT_FALSE(hasFlag(status, StatusFlag::LoopActive));
  const PlcStatus later = plcStatus(view, 51.1);
  EXPECT_EQ(later.process.flow_mm3_s, 0.0F);
  EXPECT_FALSE(hasFlag(later, StatusFlag::BeamOn)) << "nobody has said so for a second";
}

}  // namespace
}  // namespace lamina
