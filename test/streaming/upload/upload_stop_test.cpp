// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/upload_stop.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// Reports what it is told to.
class ToldServer final : public PrintServer {
 public:
  ToldServer() : PrintServer(order()) {
    last_report.is_ready = true;
    last_report.has_targets = true;
    last_report.file = printed_file;
  }
  const char* firmware() const override { return "klipper"; }
  std::optional<HttpRequest> request(UploadStep) override { return std::nullopt; }
  ServerAnswer read(UploadStep, const HttpResponse&) override { return {}; }
  ChangeCommand changed(const LiveChange&) const override { return {}; }
  std::string emergencyStop() const override { return "M112"; }

  MachineReport& told() { return last_report; }

 private:
  static std::shared_ptr<const UploadOrder> order() {
    const auto program = StreamableProgram::fromText("job", "G28\n", StreamSettings());
    return std::make_shared<const UploadOrder>(UploadOrder{ProgramBody(program), "part.gcode", ""});
  }
};

StreamSettings stopSettings(EmergencyStop emergency = EmergencyStop::Never) {
  StreamSettings settings;
  settings.safe_stop_timeout_s = 30.0;
  settings.emergency_stop = emergency;
  return settings;
}

TEST(UploadStop, CancelsOnceWhilePrintingAndTwiceWhilePaused) {
  ToldServer server;
  UploadStop stop(stopSettings());
  stop.begin(0.0);
  server.told().state = PrintState::Printing;
  EXPECT_EQ(stop.judge(server, "", 1.0).next, UploadStep::Cancel);
  EXPECT_FALSE(stop.judge(server, "", 2.0).next);
  stop.notDone(UploadStep::Cancel);
  EXPECT_EQ(stop.judge(server, "", 3.0).next, UploadStep::Cancel);
  server.told().state = PrintState::Paused;
  EXPECT_EQ(stop.judge(server, "", 4.0).next, UploadStep::Cancel);
  EXPECT_EQ(stop.judge(server, "", 5.0).next, UploadStep::Cancel);
  EXPECT_FALSE(stop.judge(server, "", 6.0).next);
  EXPECT_EQ(stop.until(), 30.0);
  server.told().state = PrintState::Changing;
  EXPECT_FALSE(stop.judge(server, "", 7.0).next);
  EXPECT_EQ(stop.until(), 37.0);
}

TEST(UploadStop, TurnsHeatersOffAgainAfterFiveSeconds) {
  ToldServer server;
  UploadStop stop(stopSettings());
  stop.begin(0.0);
  stop.seen();
  EXPECT_EQ(stop.judge(server, "", 1.0).next, UploadStep::HeatersOff);
  stop.heatersAsked(1.0);
  EXPECT_FALSE(stop.judge(server, "", 5.9).next);
  EXPECT_EQ(stop.judge(server, "", 6.0).next, UploadStep::HeatersOff);
  server.told().has_targets = false;
  server.told().is_moving = true;
  EXPECT_FALSE(stop.judge(server, "", 27.9).confirmation);
  EXPECT_NE(stop.judge(server, "", 28.0).confirmation->find("still moving"), std::string::npos);
  server.told().is_moving = false;
  EXPECT_EQ(*stop.judge(server, "", 7.0).confirmation,
            "; the machine has ended the print, and its heaters are off");
}

TEST(UploadStop, RemovesTheFileOfAPrintThatWasNotSeen) {
  ToldServer server;
  UploadStop stop(stopSettings());
  stop.begin(0.0);
  EXPECT_EQ(stop.judge(server, "", 1.0).next, UploadStep::Remove);
  stop.removed();
  EXPECT_EQ(stop.judge(server, "", 2.0).next, UploadStep::HeatersOff);
  server.told().state = PrintState::Printing;
  server.told().file = "other.gcode";
  EXPECT_NE(stop.judge(server, "", 3.0).confirmation->find("\"other.gcode\", was left alone"),
            std::string::npos);
}

TEST(UploadStop, AsksForAnEmergencyStopIfItMay) {
  ToldServer server;
  UploadStop never(stopSettings());
  never.begin(0.0);
  EXPECT_FALSE(never.takeEmergencyStop(server, 30.0));
  EXPECT_NE(never.remark(server).find("is not kept waiting: M112"), std::string::npos);

  UploadStop stop(stopSettings(EmergencyStop::Unconfirmed));
  stop.begin(0.0);
  EXPECT_TRUE(stop.takeEmergencyStop(server, 30.0));
  EXPECT_EQ(stop.until(), 60.0);
  EXPECT_FALSE(stop.takeEmergencyStop(server, 60.0)) << "once";
  server.told().state = PrintState::Printing;
  EXPECT_EQ(stop.judge(server, "", 31.0).next, UploadStep::EmergencyStop);
  stop.emergencyStopTaken();
  EXPECT_FALSE(stop.isEmergencyStopDue());
  EXPECT_NE(stop.remark(server).find("asked for: the server has taken it"), std::string::npos);
  server.told().is_halted = true;
  EXPECT_NE(stop.judge(server, "", 32.0).confirmation->find("emergency stop"), std::string::npos);
}

}  // namespace
}  // namespace lamina
