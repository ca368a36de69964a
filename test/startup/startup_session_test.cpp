// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs start-ups on emulated machines over pseudo-terminals, a thousand times as fast as real.
#include "lamina/startup/startup_session.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"
#include "startup/large_gantry.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using StartupSessionStep = StartupStep;
using State = StartupState;

constexpr double kSpeedUp = 1000.0;

/// A machine that says that it is busy, for ever, and takes nothing: one that waits for a person.
class BusyMachine {
 public:
  BusyMachine() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    EXPECT_EQ(::grantpt(master_), 0);
    EXPECT_EQ(::unlockpt(master_), 0);
    std::array<char, 64> name{};
    EXPECT_EQ(::ptsname_r(master_, name.data(), name.size()), 0);
    port_ = name.data();
    slave_ = ::open(port_.c_str(), O_RDWR | O_NOCTTY);  // what is written before anybody opens it is kept
    thread_ = std::thread([this] { speak(); });
  }
  ~BusyMachine() {
    is_over_ = true;
    thread_.join();
    ::close(slave_);
    ::close(master_);
  }
  BusyMachine(const BusyMachine&) = delete;
  BusyMachine& operator=(const BusyMachine&) = delete;

  const std::string& port() const { return port_; }

 private:
  void speak() const {
    constexpr std::string_view kBusy = "echo:busy: paused for user\n";
    std::array<char, 256> heard{};
    while (!is_over_) {
      static_cast<void>(::write(master_, kBusy.data(), kBusy.size()) +
                        ::read(master_, heard.data(), heard.size()));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  int master_;
  int slave_ = -1;
  std::string port_;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

/// Lets the process open no file while it lives.
class NoFreeFile {
 public:
  NoFreeFile() {
    EXPECT_EQ(::getrlimit(RLIMIT_NOFILE, &before_), 0);
    const int next = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::close(next);
    const rlimit none{static_cast<rlim_t>(next), before_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  }
  ~NoFreeFile() { ::setrlimit(RLIMIT_NOFILE, &before_); }
  NoFreeFile(const NoFreeFile&) = delete;
  NoFreeFile& operator=(const NoFreeFile&) = delete;

 private:
  rlimit before_{};
};

class StartupSessionTest : public testing::Test {
 protected:
  StartupSessionTest() {
    settings_.speed_up = kSpeedUp;
    settings_.check_interval_s = 0.05;
    settings_.skip = "dry_pellets power_on transfer_program";
    settings_.bed_target_c = 40.0;
    settings_.bed_max_rate_c_min = 1000.0;  // a busy computer looks late
    stream_.probe_after_s = 0.3;
    stream_.temperature_interval_s = 20;
    emulated_.speed_up = kSpeedUp;
  }

  void plugIn(const std::vector<Fault>& faults = {}) {
    EmulatedObserver observer;
    observer.line = [this](const ExecutedLine& line) {
      const std::lock_guard<std::mutex> lock(mutex_);
      commands_.push_back(line.command);
    };
    machine_ = std::make_unique<EmulatedMachine>(emulated_, faults, EmulatedPorts{port(), {}}, observer);
  }
  void startSession() {
    session_ = std::make_unique<StartupSession>(settings_, stream_, MachinePort{port(), 115200},
                                                [this](const StartupReport& report) {
                                                  const std::lock_guard<std::mutex> lock(mutex_);
                                                  reported_ = report;
                                                });
  }
  std::string port() const { return folder_.file("machine"); }

  StartupStatus statusOf(StartupSessionStep step) const {
    for (const StartupStatus& status : session_->steps())
      if (status.step == step) return status;
    ADD_FAILURE() << "no step " << toString(step);
    return {};
  }
  static bool waitUntil(const std::function<bool()>& is_true) {
    for (int i = 0; i < 6000 && !is_true(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return is_true();
  }
  void expectState(StartupSessionStep step, State state) const {
    EXPECT_TRUE(waitUntil([&] { return statusOf(step).state == state; }))
        << toString(step) << " is " << toString(statusOf(step).state) << ": " << statusOf(step).reason;
  }
  void run(std::optional<StartupSessionStep> step = std::nullopt) {
    EXPECT_TRUE(waitUntil([&] { return !session_->isBusy(); }));
    EXPECT_NO_THROW(session_->run(step));
  }
  void runAll() {
    run();
    expectState(StartupSessionStep::HomeZ, State::Done);
    session_->confirm(StartupSessionStep::PlaceSheet);
    run();
    expectState(StartupSessionStep::MapHeights, State::Done);
    EXPECT_TRUE(waitUntil([&] { return !session_->isBusy(); }));
  }
  bool hasRun(const std::string& command) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::find(commands_.begin(), commands_.end(), command) != commands_.end();
  }
  static ErrorCode codeOf(const std::function<void()>& request) {
    try {
      request();
      return ErrorCode::Ok;
    } catch (const Error& error) {
      return error.code();
    }
  }
  /// A job as the node runs it.
  StreamStatus stream(const std::string& text) {
    const auto program = StreamableProgram::fromText("part", text);
    session_->beginJob({program.name(), 0, 0}, [] { return true; });
    StreamSession job(program, stream_, {port(), 115200}, {},
                      {[this](const FirmwareReply& reply) { session_->heard(reply); }, {}});
    EXPECT_TRUE(job.waitFor(60.0));
    session_->endJob(program, job.status());
    return job.status();
  }

  test::ScratchFolder folder_;
  StartupSettings settings_ = test::largeGantry();
  EmulatedSettings emulated_ = test::emulatedLargeGantry();
  StreamSettings stream_;
  mutable std::mutex mutex_;
  std::vector<std::string> commands_;
  StartupReport reported_;  ///< to the observer, last
  std::unique_ptr<EmulatedMachine> machine_;
  std::unique_ptr<StartupSession> session_;
};

TEST_F(StartupSessionTest, RunsAllStepsAndLendsThePortToJobs) {
  plugIn();
  startSession();
  EXPECT_EQ(codeOf([&] { stream("G1 X1"); }), ErrorCode::Rejected);
  runAll();
  EXPECT_EQ(stream("G90\nG1 X10 F6000").state, PackmlState::Complete);
  EXPECT_EQ(stream("G1 X20\nM84").state, PackmlState::Complete);
  EXPECT_EQ(statusOf(StartupSessionStep::HomeX).state, State::Pending);
  EXPECT_EQ(codeOf([&] { stream("G1 X1"); }), ErrorCode::Rejected);
}

TEST_F(StartupSessionTest, LosesNothingToAJobThatDoesNotBegin) {
  plugIn();
  startSession();
  runAll();
  EXPECT_EQ(codeOf([&] { session_->beginJob({"part", 0, 0}, [] { return false; }); }), ErrorCode::Cancelled);
  EXPECT_EQ(statusOf(StartupSessionStep::HomeX).state, State::Done);
  EXPECT_EQ(stream("G90\nG1 X10 F6000").state, PackmlState::Complete) << "the port is free";
}

TEST_F(StartupSessionTest, FreesThePortThoughTheProgramOfTheJobCannotBeReadAgain) {
  settings_.skip += " home_x home_y home_z place_sheet draw_vacuum home_z_again map_heights";
  plugIn();
  startSession();
  run();
  expectState(StartupSessionStep::HeatBed, State::Done);
  EXPECT_TRUE(waitUntil([&] { return !session_->isBusy(); }));
  writeFile(folder_.file("part.gcode"), "G1 X1\n");
  const auto program = StreamableProgram::fromFile(folder_.file("part.gcode"));
  session_->beginJob({program.name(), 0, 0}, [] { return true; });
  StreamStatus status;
  status.state = PackmlState::Complete;
  status.lines_sent = 1;
  {
    const NoFreeFile none;
    EXPECT_EQ(codeOf([&] { session_->endJob(program, status); }), ErrorCode::Ok);
  }
  EXPECT_EQ(statusOf(StartupSessionStep::HeatBed).state, State::Pending) << "what was sent is not known";
  EXPECT_EQ(codeOf([&] { session_->abort(); }), ErrorCode::Ok) << "the port is free";
}

TEST_F(StartupSessionTest, StopsTheCheckBeforeAJobThatIsNotToBegin) {
  settings_.skip += " heat_bed place_sheet draw_vacuum home_z_again map_heights";
  settings_.check_code += "\nG4 S3000";  // 3 s
  settings_.check_interval_s = 1000.0;   // nobody else asks
  plugIn();
  startSession();
  run();
  expectState(StartupSessionStep::HomeZ, State::Done);
  EXPECT_TRUE(waitUntil([&] { return !session_->isBusy(); }));
  const auto waits = [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::count(commands_.begin(), commands_.end(), "G4 S3000");
  };
  const auto before = waits();
  EXPECT_EQ(codeOf([&] {
              session_->beginJob({"part", 0, 0}, [&] { return waits() == before; });
            }),
            ErrorCode::Cancelled);
}

TEST_F(StartupSessionTest, SeesMotorsThatSomebodyElseSwitchedOff) {
  plugIn();
  startSession();
  runAll();
  const auto program = StreamableProgram::fromText("elsewhere", "M84 X");
  {
    StreamSession other(program, stream_, {port(), 115200}, {});
    other.waitFor(60.0);
  }
  expectState(StartupSessionStep::HomeX, State::Pending);
  EXPECT_NE(statusOf(StartupSessionStep::HomeX).reason.find("homed: YZ"), std::string::npos)
      << statusOf(StartupSessionStep::HomeX).reason;
}

TEST_F(StartupSessionTest, SwitchesOffABedThatDoesNotGetHot) {
  emulated_.bed_limit_c = 33.0;
  settings_.bed_timeout_min = 10.0;
  plugIn();
  startSession();
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Failed);
  EXPECT_NE(statusOf(StartupSessionStep::HeatBed)
                .reason.find("the bed is at 33 degC; expected 39 to 41 degC within 10 min"),
            std::string::npos)
      << statusOf(StartupSessionStep::HeatBed).reason;
  EXPECT_TRUE(waitUntil([&] { return machine_->bedTarget() == 0.0 && hasRun("M42 P4 S0"); }));
}

TEST_F(StartupSessionTest, LeavesTheMachineSafeWhenItIsAborted) {
  plugIn();
  settings_.bed_target_c = 150.0;
  startSession();
  run();
  EXPECT_TRUE(waitUntil([&] { return machine_->bedTarget() > 26.0; }));
  EXPECT_EQ(codeOf([&] { session_->run(StartupSessionStep::HomeX); }), ErrorCode::Rejected);
  session_->abort();
  expectState(StartupSessionStep::HeatBed, State::Pending);
  EXPECT_TRUE(waitUntil([&] { return !session_->isBusy(); }));
  EXPECT_EQ(statusOf(StartupSessionStep::HeatBed).reason.substr(0, 18), "aborted on request");
  EXPECT_DOUBLE_EQ(machine_->bedTarget(), 0.0);
  EXPECT_TRUE(hasRun("M42 P1 S0"));
}

TEST_F(StartupSessionTest, WaitsForABusyMachineUntilItEnds) {
  auto machine = std::make_unique<BusyMachine>();
  std::filesystem::create_symlink(machine->port(), port());
  stream_.safe_stop_timeout_s = 0.3;
  startSession();
  run(StartupSessionStep::HeatBed);
  session_->abort();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_TRUE(session_->isBusy()) << "the code is still to be sent";
  session_->end();
  EXPECT_NE(
      statusOf(StartupSessionStep::HeatBed)
          .reason.find("look after it: it has not run startup.abort_code, nor a line of it within 0.3 s"),
      std::string::npos)
      << statusOf(StartupSessionStep::HeatBed).reason;
  machine.reset();  // or a session that waits would not end
}

TEST_F(StartupSessionTest, LeavesTheMachineSafeWhenItEnds) {
  plugIn();
  startSession();
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Done);
  EXPECT_DOUBLE_EQ(machine_->bedTarget(), 40.0);
  session_.reset();
  EXPECT_DOUBLE_EQ(machine_->bedTarget(), 0.0);
  ASSERT_FALSE(reported_.steps.empty());
  for (const StartupStatus& status : reported_.steps) {
    EXPECT_NE(status.state, State::Done) << toString(status.step);
    EXPECT_NE(status.state, State::Running) << toString(status.step);
  }
  EXPECT_FALSE(reported_.may_be_on);
}

TEST_F(StartupSessionTest, LeavesTheMachineSafeWhenItEndsAfterTheLinkWasLost) {
  plugIn();
  startSession();
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Done);
  std::filesystem::rename(port(), folder_.file("unplugged"));
  expectState(StartupSessionStep::HeatBed, State::Pending);
  EXPECT_TRUE(session_->report().may_be_on);
  EXPECT_DOUBLE_EQ(machine_->bedTarget(), 40.0);
  std::filesystem::rename(folder_.file("unplugged"), port());
  session_.reset();
  EXPECT_DOUBLE_EQ(machine_->bedTarget(), 0.0);
  EXPECT_FALSE(reported_.may_be_on);
}

TEST_F(StartupSessionTest, AsksALostMachineUntilItSaysThatNothingIsOn) {
  plugIn();
  startSession();
  EXPECT_FALSE(session_->report().may_be_on);
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Done);
  machine_.reset();
  expectState(StartupSessionStep::HeatBed, State::Pending);
  EXPECT_TRUE(session_->report().may_be_on);
  plugIn();
  EXPECT_TRUE(waitUntil([&] { return !session_->report().may_be_on; })) << "its heaters are off";
}

TEST_F(StartupSessionTest, TakesNothingOnceItIsEnded) {
  plugIn();
  startSession();
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Done);
  session_->end();
  EXPECT_DOUBLE_EQ(machine_->bedTarget(), 0.0) << "the machine is left safe by then";
  EXPECT_EQ(statusOf(StartupSessionStep::HeatBed).state, State::Pending);
  EXPECT_EQ(codeOf([&] { session_->run(StartupSessionStep::HeatBed); }), ErrorCode::Rejected);
  EXPECT_EQ(codeOf([&] { session_->abort(); }), ErrorCode::Rejected);
  EXPECT_EQ(codeOf([&] { stream("G1 X1"); }), ErrorCode::Rejected);
  EXPECT_FALSE(session_->isBusy());
}

TEST_F(StartupSessionTest, SaysThatABedIsHotThatItMayNotSwitchOff) {
  settings_.abort_code.clear();
  plugIn();
  startSession();
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Done);
  session_.reset();
  EXPECT_DOUBLE_EQ(machine_->bedTarget(), 40.0);
  EXPECT_TRUE(std::any_of(reported_.steps.begin(), reported_.steps.end(), [](const StartupStatus& status) {
    return status.step == StartupSessionStep::HeatBed && status.state == State::Done;
  }));
  EXPECT_TRUE(reported_.may_be_on);
}

TEST_F(StartupSessionTest, ReportsThatNoMachineIsThere) {
  startSession();
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Failed);
  EXPECT_NE(statusOf(StartupSessionStep::HeatBed).reason.find("look after it"), std::string::npos)
      << statusOf(StartupSessionStep::HeatBed).reason;
}

TEST_F(StartupSessionTest, LosesEverythingWhenTheMachineIsGone) {
  plugIn();
  startSession();
  run(StartupSessionStep::HeatBed);
  expectState(StartupSessionStep::HeatBed, State::Done);
  machine_.reset();
  expectState(StartupSessionStep::HeatBed, State::Pending);
}

TEST_F(StartupSessionTest, RefusesCodesThatCannotBeStreamed) {
  settings_.abort_code = "M104 S0*12";
  stream_.firmware = "marlin";
  EXPECT_EQ(codeOf([&] { startSession(); }), ErrorCode::InvalidConfig);
}

TEST_F(StartupSessionTest, WithoutASequenceLetsJobsStart) {
  settings_ = {};
  plugIn();
  startSession();
  EXPECT_TRUE(session_->isEmpty());
  EXPECT_EQ(stream("G1 X1").state, PackmlState::Complete);
  EXPECT_EQ(codeOf([&] { session_->abort(); }), ErrorCode::Rejected);
}

}  // namespace
}  // namespace lamina
