// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/stream_messages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

StreamStatus starved(StarvationSource source) {
  StreamStatus status;
  status.starvation.source = source;
  status.starvation.count = 2;
  status.starvation.longest_s = 3.8;
  status.starvation.line = 7;
  return status;
}

std::map<std::string, std::string> diagnosticsOf(const StreamStatus& status) {
  diagnostic_updater::DiagnosticStatusWrapper wrapper;
  fillDiagnostics(status, wrapper);
  std::map<std::string, std::string> values;
  for (const auto& pair : wrapper.values) values[pair.key] = pair.value;
  return values;
}

TEST(StreamMessages, TakeAFractionForThePercentThatItStandsFor) {
  // 100 * 1.1 is 110.00000000000001, and 100 * 2.3 below 230.
  EXPECT_EQ(liveChangeOf("spindle", 1.1).value, 110.0);
  EXPECT_EQ(liveChangeOf("feed", 2.3).value, 230.0);
  EXPECT_EQ(liveChangeOf("power", 1.1).value, 110.0);
  for (int percent = 10; percent <= 200; ++percent)
    EXPECT_EQ(liveChangeOf("spindle", 0.01 * percent).value, percent);
  EXPECT_EQ(liveChangeOf("babystep", -0.00005).value, -0.05) << "mm";
  EXPECT_EQ(liveChangeOf("cancel_part", 2.0).value, 2.0);
  try {
    liveChangeOf("spindle", 1.105);
    ADD_FAILURE() << "grbl takes whole percents";
  } catch (const InvalidInput& refusal) {
    EXPECT_STREQ(refusal.what(), "spindle is 110.5 %; must be a whole number from 10 to 200 %");
  }
}

TEST(StreamMessages, SayThatWhatIsNotReportedIsNotKnown) {
  StreamStatus status;
  const lamina_msgs::MachineState silent = toMachineState(status, "part");
  for (const double value : {silent.position.x, silent.position.y, silent.position.z,
                             silent.nozzle_temperature, silent.bed_temperature})
    EXPECT_TRUE(std::isnan(value)) << value;
  status.temperatures.emplace();
  status.temperatures->nozzle_c = 210.0;
  status.position.emplace();
  status.position->x = 20.0;
  const lamina_msgs::MachineState heard = toMachineState(status, "part");
  EXPECT_EQ(heard.nozzle_temperature, 210.0);
  EXPECT_TRUE(std::isnan(heard.bed_temperature)) << "a machine without a bed heater";
  EXPECT_DOUBLE_EQ(heard.position.x, 0.02) << "m";
}

TEST(StreamMessages, SayForWhomAMachineWaitsUnlessItsJobHasFailed) {
  StreamStatus status;
  status.state = PackmlState::Held;
  status.wait = "the machine waits for a person";
  EXPECT_EQ(toMachineState(status, "a").status.message, status.wait);
  EXPECT_EQ(toMachineState(status, "a").status.code, lamina_msgs::Status::OK);
  status.failure = {ErrorCode::Cancelled, "aborted on request"};
  EXPECT_EQ(toMachineState(status, "a").status.message, "aborted on request");
}

TEST(StreamMessages, CountNoFurtherThanMessagesDo) {
  StreamStatus status;
  status.lines_total = (std::uint64_t{1} << 32) + 5;
  EXPECT_EQ(toMachineState(status, "part").lines_total, 4294967295U);
}

TEST(StreamMessages, TellWhoCountsStarvations) {
  const lamina_msgs::StreamProgramResult by_streamer = toResult(starved(StarvationSource::Streamer), 1.0);
  EXPECT_EQ(by_streamer.starvations_counted_by, "streamer");
  EXPECT_EQ(by_streamer.longest_starvation, 3.8);
  const lamina_msgs::StreamProgramResult by_machine = toResult(starved(StarvationSource::Machine), 1.0);
  EXPECT_EQ(by_machine.starvations, 2U);
  EXPECT_EQ(by_machine.starvations_counted_by, "machine");
  EXPECT_TRUE(std::isnan(by_machine.longest_starvation));
  const lamina_msgs::StreamProgramResult by_nobody = toResult(starved(StarvationSource::Nobody), 1.0);
  EXPECT_EQ(by_nobody.starvations_counted_by, "nobody");
  EXPECT_TRUE(std::isnan(by_nobody.longest_starvation));
}

TEST(StreamMessages, DiagnoseNoStarvationThatNobodyReports) {
  auto values = diagnosticsOf(starved(StarvationSource::Streamer));
  EXPECT_EQ(values["times starved"], "2");
  EXPECT_EQ(std::stod(values["longest starvation [s]"]), 3.8);
  values = diagnosticsOf(starved(StarvationSource::Machine));
  EXPECT_EQ(values["times starved"], "2");
  EXPECT_EQ(values["longest starvation [s]"], "not reported by this firmware");
  values = diagnosticsOf(starved(StarvationSource::Nobody));
  EXPECT_EQ(values["times starved"], "not reported by this firmware");
  EXPECT_EQ(values["longest starvation [s]"], "not reported by this firmware");
}

}  // namespace
}  // namespace lamina
