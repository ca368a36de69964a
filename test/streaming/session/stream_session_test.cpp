// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Jobs over real pseudo-terminals and TCP connections.
#include "lamina/streaming/session/stream_session.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <mutex>
#include <thread>

#include "lamina/base/error.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"
#include "streaming/emulator/simulated_link.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr double kPatience = 60.0;  // s: far above what a job takes, for loaded machines

std::string linkPath() {
  static const test::ScratchFolder folder;
  return folder.file("machine");
}

/// An emulated machine as fast as possible, and the numbered lines it has run.
class RecordedMachine {
 public:
  explicit RecordedMachine(double speed_up, std::vector<Fault> faults = {}, int seed = 1) {
    EmulatedSettings settings;
    settings.speed_up = speed_up;
    settings.fault_seed = seed;
    settings.fault_delay_s = 0.02;
    settings.fault_silence_s = 0.05;
    EmulatedObserver observer;
    observer.line = [this](const ExecutedLine& line) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (line.number && line.command.compare(0, 4, "M110") != 0) commands_.push_back(line.command);
    };
    machine_ = std::make_unique<EmulatedMachine>(settings, std::move(faults), EmulatedPorts{linkPath(), 0},
                                                 observer);
  }
  std::vector<std::string> commands() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return commands_;
  }
  const EmulatedMachine* operator->() const { return machine_.get(); }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> commands_;
  std::unique_ptr<EmulatedMachine> machine_;
};

/// Time-outs for a machine that is right beside.
StreamSettings impatient() {
  StreamSettings settings;
  settings.probe_after_s = 0.2;
  settings.settle_s = 0.005;
  return settings;
}

StreamableProgram spiral(int lines) {
  return StreamableProgram::fromText("spiral", test::spiralProgram(lines));
}

StreamStatus finished(const StreamSession& session) {
  EXPECT_TRUE(session.waitFor(kPatience));
  return session.status();
}

template <class Condition>
bool waitUntil(Condition is_true) {
  for (double waited = 0.0; waited < kPatience && !is_true(); waited += 0.002) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return is_true();
}

class FaultyPort : public testing::TestWithParam<std::tuple<FaultKind, int>> {};

TEST_P(FaultyPort, LosesNoLineAndRepeatsNone) {
  const auto [kind, seed] = GetParam();
  const auto program = spiral(5000);
  const RecordedMachine machine(0.0, {{kind, 0.002, {1, 4, 2500, 5000}}}, seed);
  const StreamSession session(program, impatient(), {machine->pty(), 115200}, {});
  const StreamStatus status = finished(session);
  EXPECT_EQ(status.state, PackmlState::Complete) << status.failure.message;
  EXPECT_EQ(status.lines_acknowledged, 5000U);
  EXPECT_EQ(machine.commands(), test::commandsOf(program));
  EXPECT_GT(machine->counts().faults, 4U);
}

INSTANTIATE_TEST_SUITE_P(EveryKind, FaultyPort,
                         testing::Combine(testing::Values(FaultKind::LostOk, FaultKind::DelayedOk,
                                                          FaultKind::LostLine, FaultKind::CorruptedLine,
                                                          FaultKind::SpuriousResend, FaultKind::Silence),
                                          testing::Values(1, 2)),
                         [](const auto& tested) {
                           return std::string(toString(std::get<0>(tested.param))) + "_seed_" +
                                  std::to_string(std::get<1>(tested.param));
                         });

TEST(StreamSession, LosesNoLineUnderAllFaultsAtOnce) {
  const auto program = spiral(5000);
  for (const int seed : {1, 2, 3}) {
    const RecordedMachine machine(0.0,
                                  {{FaultKind::LostOk, 0.001, {}},
                                   {FaultKind::DelayedOk, 0.001, {}},
                                   {FaultKind::LostLine, 0.001, {}},
                                   {FaultKind::CorruptedLine, 0.005, {}},
                                   {FaultKind::SpuriousResend, 0.002, {}},
                                   {FaultKind::Silence, 0.0005, {}}},
                                  seed);
    const StreamSession session(program, impatient(), {machine->pty(), 115200}, {});
    EXPECT_EQ(finished(session).state, PackmlState::Complete) << session.status().failure.message;
    EXPECT_EQ(machine.commands(), test::commandsOf(program));
  }
}

TEST(StreamSession, StreamsOverTcp) {
  const auto program = spiral(5000);
  const RecordedMachine machine(0.0, {{FaultKind::CorruptedLine, 0.002, {}}});
  const StreamSession session(program, impatient(),
                              {"tcp:127.0.0.1:" + std::to_string(machine->tcpPort()), 0}, {});
  EXPECT_EQ(finished(session).state, PackmlState::Complete) << session.status().failure.message;
  EXPECT_EQ(machine.commands(), test::commandsOf(program));
}

TEST(StreamSession, NeverOverflowsTheReceiveBufferOfAFullMachine) {
  const auto program = spiral(400);
  const RecordedMachine machine(300.0);
  const StreamSession session(program, impatient(), {machine->pty(), 115200}, {});
  EXPECT_EQ(finished(session).state, PackmlState::Complete) << session.status().failure.message;
  EXPECT_EQ(machine->counts().bytes_lost, 0U);
  EXPECT_EQ(machine.commands(), test::commandsOf(program));
}

TEST(StreamSession, HoldsAndGoesOnThroughFaults) {
  const auto program = spiral(1500);
  const RecordedMachine machine(500.0, {{FaultKind::LostOk, 0.01, {}}, {FaultKind::CorruptedLine, 0.01, {}}});
  StreamSession session(program, impatient(), {machine->pty(), 115200}, {});
  for (const std::uint64_t at : {100U, 400U, 800U}) {
    ASSERT_TRUE(waitUntil([&] { return machine.commands().size() > at; }));
    session.pause();
    ASSERT_TRUE(waitUntil([&] { return session.status().state == PackmlState::Held; }));
    const std::size_t held_at = machine.commands().size();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(machine.commands().size(), held_at);
    session.resume();
  }
  EXPECT_EQ(finished(session).state, PackmlState::Complete) << session.status().failure.message;
  EXPECT_EQ(machine.commands(), test::commandsOf(program));
}

TEST(StreamSession, LeavesTheMachineSafeAfterAnAbort) {
  const auto program =
      StreamableProgram::fromText("hot", "M104 S200\nM140 S60\n" + test::spiralProgram(1000));
  const RecordedMachine machine(2.0, {{FaultKind::CorruptedLine, 0.2, {}}, {FaultKind::LostOk, 0.1, {}}});
  StreamSession session(program, impatient(), {machine->pty(), 115200}, {});
  ASSERT_TRUE(waitUntil([&] { return machine.commands().size() > 20; }));
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 200.0);
  session.abort({ErrorCode::Cancelled, "enough"});
  const StreamStatus status = finished(session);
  EXPECT_EQ(status.state, PackmlState::Aborted);
  EXPECT_EQ(status.failure.code, ErrorCode::Cancelled);
  EXPECT_THROW(throwIfFailed(status), Cancelled);
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 0.0);
  EXPECT_DOUBLE_EQ(machine->bedTarget(), 0.0);
  EXPECT_TRUE(waitUntil([&] { return machine->isIdle(); }));
  EXPECT_LT(machine.commands().size(), 900U);
}

TEST(StreamSession, StopsTheMachineWhenItIsAbandoned) {
  const auto program = StreamableProgram::fromText("hot", "M104 S200\n" + test::spiralProgram(1000));
  const RecordedMachine machine(2.0);
  {
    const StreamSession session(program, impatient(), {machine->pty(), 115200}, {});
    ASSERT_TRUE(waitUntil([&] { return machine.commands().size() > 20; }));
  }
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 0.0);
}

TEST(StreamSession, BreaksHeatingOnAnAbort) {
  const auto program = StreamableProgram::fromText("hot", "M109 S200\nG1 X1\n");
  const RecordedMachine machine(1.0);
  StreamSession session(program, impatient(), {machine->pty(), 115200}, {});
  ASSERT_TRUE(waitUntil([&] { return machine->nozzleTarget() > 0.0; }));
  session.abort({ErrorCode::Cancelled, "enough"});
  EXPECT_EQ(finished(session).failure.message.find("did not confirm"), std::string::npos);
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 0.0);
}

TEST(StreamSession, ReportsWhereTheLinkWasLost) {
  const RecordedMachine machine(0.0, {{FaultKind::Disconnect, 0.0, {100}}});
  const std::string port = machine->pty();
  StreamSettings settings = impatient();
  settings.safe_stop_timeout_s = 0.3;
  const StreamSession session(spiral(200), settings, {port, 115200}, {});
  const StreamStatus status = finished(session);
  EXPECT_EQ(status.failure.code, ErrorCode::Disconnected);
  EXPECT_EQ(status.failure.message.compare(0, port.size(), port), 0) << status.failure.message;
  EXPECT_GE(status.lines_acknowledged, 90U);
  EXPECT_LT(status.lines_acknowledged, 100U);
  EXPECT_THROW(throwIfFailed(status), Disconnected);
}

TEST(StreamSession, TurnsHeatersOffOnceTheLinkIsBack) {
  const RecordedMachine machine(0.0, {{FaultKind::Disconnect, 0.0, {100}}});
  const auto program = StreamableProgram::fromText("hot", "M104 S200\nM140 S60\n" + test::spiralProgram(200));
  const StreamSession session(program, impatient(), {linkPath(), 115200}, {});
  const StreamStatus status = finished(session);
  EXPECT_EQ(status.failure.code, ErrorCode::Disconnected);
  EXPECT_EQ(status.failure.message.find("look after it"), std::string::npos) << status.failure.message;
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 0.0);
}

TEST(StreamSession, RefusesToGoOnWithAProgramThatWasChanged) {
  const std::string path = linkPath() + ".gcode";
  std::ofstream(path) << test::spiralProgram(4000);
  const RecordedMachine machine(60.0);  // slow enough to be under way for long
  StreamSession session(StreamableProgram::fromFile(path), impatient(), {machine->pty(), 115200}, {});
  ASSERT_TRUE(waitUntil([&] { return session.status().lines_acknowledged > 5; }));
  std::ofstream(path) << "G1 X1\n";
  const StreamStatus status = finished(session);
  EXPECT_EQ(status.failure.code, ErrorCode::InvalidProgram);
  EXPECT_NE(status.failure.message.find("of 4000"), std::string::npos) << status.failure.message;
  EXPECT_THROW(throwIfFailed(status), InvalidProgram);
  std::remove(path.c_str());
}

TEST(StreamSession, StreamsAgainOnceTheLinkIsBack) {
  const RecordedMachine machine(0.0, {{FaultKind::Disconnect, 0.0, {100}}});
  const auto program = spiral(200);
  finished(StreamSession(program, impatient(), {machine->pty(), 115200}, {}));
  const std::size_t before = machine.commands().size();
  ASSERT_TRUE(waitUntil([&] { return ::access(linkPath().c_str(), F_OK) == 0; }));
  const StreamSession again(program, impatient(), {machine->pty(), 115200}, {});
  EXPECT_EQ(finished(again).state, PackmlState::Complete) << again.status().failure.message;
  EXPECT_EQ(machine.commands().size(), before + 200U);
}

TEST(StreamSession, AbortsWhenTheMachineIsReset) {
  const RecordedMachine machine(0.0, {{FaultKind::Reset, 0.0, {100}}});
  const StreamSession session(spiral(200), impatient(), {machine->pty(), 115200}, {});
  EXPECT_EQ(finished(session).failure.code, ErrorCode::DeviceError);
}

TEST(StreamSession, LeavesAPortToTheProcessThatHasIt) {
  RecordedMachine machine(1.0);
  const StreamSession first(spiral(200), impatient(), {linkPath(), 115200}, {});
  try {
    const StreamSession second(spiral(5), impatient(), {linkPath(), 115200}, {});
    ADD_FAILURE() << "it was opened by both";
  } catch (const Disconnected& error) {
    EXPECT_NE(std::string(error.what()).find("; another program has it open"), std::string::npos)
        << error.what();
  }
}

TEST(StreamSettings, TakeTheLinkFromThePort) {
  RecordedMachine machine(0.0);
  EXPECT_EQ(linkOf(linkPath()), LinkKind::Reliable) << "a link to a pseudo-terminal";
  EXPECT_EQ(linkOf("tcp:printer.local:23"), LinkKind::Reliable);
  EXPECT_EQ(linkOf("/dev/ttyACM7"), LinkKind::Reliable);
  EXPECT_EQ(linkOf("/dev/ttyUSB0"), LinkKind::Lossy);
  EXPECT_EQ(linkOf("/dev/ttyS3"), LinkKind::Lossy);
  EXPECT_EQ(windowLines({}, LinkKind::Lossy), 1);
  EXPECT_EQ(windowLines({}, LinkKind::Reliable), 4);
}

TEST(StreamSession, SaysAtOnceThatThereIsNoMachine) {
  const auto program = spiral(10);
  EXPECT_THROW(StreamSession(program, {}, {"/dev/there_is_no_such_port", 115200}, {}), Disconnected);
  EXPECT_THROW(StreamSession(program, {}, {"/dev/null", 115200}, {}), Disconnected);
  EXPECT_THROW(StreamSession(program, {}, {"tcp:127.0.0.1:1", 0}, {}), Disconnected);
  EXPECT_THROW(StreamSession(program, {}, {"tcp:nowhere", 0}, {}), InvalidInput);
  EXPECT_THROW(StreamSession(program, {}, {"", 0}, {}), InvalidInput);
}

TEST(StreamSession, ReportsEveryStateInOrder) {
  const RecordedMachine machine(0.0);
  std::vector<PackmlState> states;
  {
    const StreamSession session(spiral(1000), impatient(), {machine->pty(), 115200},
                                [&](const StreamStatus& status) {
                                  if (states.empty() || states.back() != status.state)
                                    states.push_back(status.state);
                                });
    finished(session);
  }
  EXPECT_EQ(states, (std::vector<PackmlState>{PackmlState::Starting, PackmlState::Execute,
                                              PackmlState::Completing, PackmlState::Complete}));
}

TEST(StreamSession, GoesOnWithoutAProgressFileWhoseNameNoFileSystemTakes) {
  const RecordedMachine machine(0.0);
  const test::ScratchFolder folder;
  SessionOptions options;
  options.journal.path = folder.file(std::string(300, 'p'));
  const StreamSession session(spiral(20), impatient(), {machine->pty(), 115200}, {}, options);
  EXPECT_EQ(finished(session).state, PackmlState::Complete) << session.status().failure.message;
  EXPECT_NE(session.status().message.find("the job goes on"), std::string::npos) << session.status().message;
}

TEST(StreamSession, BeginsNoExecutionThatNothingStates) {
  const RecordedMachine machine(0.0);
  const test::ScratchFolder folder;
  SessionOptions options;
  options.journal.path = folder.file(std::string(300, 'p'));
  options.journal.execution = "e-1";
  const StreamSession session(spiral(20), impatient(), {machine->pty(), 115200}, {}, options);
  const StreamStatus status = finished(session);
  EXPECT_EQ(status.state, PackmlState::Aborted);
  EXPECT_EQ(status.failure.code, ErrorCode::FileError);
  EXPECT_NE(status.failure.message.find("no line of execution e-1 was sent"), std::string::npos)
      << status.failure.message;
  EXPECT_EQ(status.lines_sent, 0U);
  for (const std::string& command : machine.commands()) EXPECT_NE(command.substr(0, 4), "G1 X") << command;
}

/// Corrects nothing, and keeps no record: its lines could not be made again.
class UnrecordedRevision final : public ProgramRevision {
 public:
  bool isKnown(std::int32_t /*layer*/) override { return true; }
  void decide(std::int32_t /*layer*/) override {}
  double waitTime() const override { return 0.0; }
  std::string revised(std::string_view line, std::uint64_t /*number*/) override { return std::string(line); }
};

TEST(StreamSession, StatesAnExecutionThatCouldNotGoOn) {
  const auto program = spiral(400);
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  SessionOptions options;
  options.journal.path = path;
  options.journal.execution = "e-1";
  options.revision = std::make_shared<UnrecordedRevision>();
  {
    const RecordedMachine slow(20.0);
    const StreamSession session(program, impatient(), {slow->pty(), 115200}, {}, options);
    ASSERT_TRUE(waitUntil([&] { return slow.commands().size() > 20; }));
    EXPECT_EQ(recordOf(path, "e-1"), ExecutionRecord::Unfinished) << "as a killed process leaves it";
    EXPECT_THROW(resumeJournal(path, program, slow->pty()), InvalidInput);
  }
  const RecordedMachine swift(0.0);
  options.journal.execution = "e-2";
  options.revision = std::make_shared<UnrecordedRevision>();
  const StreamSession whole(program, impatient(), {swift->pty(), 115200}, {}, options);
  EXPECT_EQ(finished(whole).state, PackmlState::Complete) << whole.status().failure.message;
  EXPECT_EQ(recordOf(path, "e-2"), ExecutionRecord::Complete);
  EXPECT_THROW(recordOf(path, "e-1"), InvalidInput);
}

TEST(EmulatedMachine, RefusesToReplaceAFileByItsLink) {
  EXPECT_THROW(EmulatedMachine({}, {}, {"/etc/passwd", {}}, {}), FileError);
  EXPECT_THROW(EmulatedMachine({}, {}, {"/nowhere/at/all", {}}, {}), FileError);
}

TEST(EmulatedMachine, RemovesItsLink) {
  {
    const RecordedMachine machine(0.0);
    ASSERT_EQ(::access(linkPath().c_str(), F_OK), 0);
  }
  EXPECT_NE(::access(linkPath().c_str(), F_OK), 0);
}

template <class Kind>
void expectThrownAs(ErrorCode code) {
  StreamStatus status;
  status.failure = {code, "why"};
  try {
    throwIfFailed(status);
    FAIL() << toString(code);
  } catch (const Kind& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_STREQ(error.what(), "why");
  }
}

TEST(StreamStatus, IsThrownAsTheErrorThatItsFailureStandsFor) {
  EXPECT_NO_THROW(throwIfFailed({}));
  expectThrownAs<Error>(ErrorCode::Internal);
  expectThrownAs<InvalidInput>(ErrorCode::InvalidInput);
  expectThrownAs<InvalidMesh>(ErrorCode::InvalidMesh);
  expectThrownAs<InvalidConfig>(ErrorCode::InvalidConfig);
  expectThrownAs<InvalidProgram>(ErrorCode::InvalidProgram);
  expectThrownAs<FileError>(ErrorCode::FileError);
  expectThrownAs<Unreachable>(ErrorCode::Unreachable);
  expectThrownAs<DeviceError>(ErrorCode::DeviceError);
  expectThrownAs<Disconnected>(ErrorCode::Disconnected);
  expectThrownAs<Rejected>(ErrorCode::Rejected);
  expectThrownAs<TimedOut>(ErrorCode::TimedOut);
  expectThrownAs<Cancelled>(ErrorCode::Cancelled);
}

}  // namespace
}  // namespace lamina
