// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Streamers that die and hang, as processes of their own, and the watch that stops the machine in their
// place.
#include "lamina/streaming/guard/streamer_watch.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <random>

#include "lamina/base/error.hpp"
#include "streaming/guard/left_machine.hpp"

namespace lamina {
namespace {

using test::comesTrue;
using test::inTemporary;
using test::LeftMachine;

/// A process that sends a pulse a hundred times a second until it is killed. It was forked from threads, and
/// so calls nothing but the system.
class PulsingProcess {
 public:
  PulsingProcess(const std::string& socket, const MachinePulse& pulse) {
    const std::string text = toText(pulse);
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    std::memcpy(place.sun_path, socket.c_str(), socket.size());
    int begun[2] = {-1, -1};
    if (::pipe(begun) != 0) return;
    process_ = ::fork();
    if (process_ == 0) beat(place, text, begun[1]);
    ::close(begun[1]);
    char byte = 0;
    EXPECT_EQ(::read(begun[0], &byte, 1), 1) << "it has not begun";
    ::close(begun[0]);
  }
  ~PulsingProcess() { die(); }
  PulsingProcess(const PulsingProcess&) = delete;
  PulsingProcess& operator=(const PulsingProcess&) = delete;

  void signal(int number) const { ::kill(process_, number); }
  void die() {
    if (process_ <= 0) return;
    signal(SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }
  int process() const { return process_; }
  /// @return whether it was ended by another than this test
  bool wasKilled() {
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) != process_) return false;
    process_ = 0;
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  }

 private:
  [[noreturn]] static void beat(const sockaddr_un& place, const std::string& text, int begun) {
    const int link = ::socket(AF_UNIX, SOCK_SEQPACKET, 0);
    if (::connect(link, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0) ::_exit(1);
    if (::send(link, text.data(), text.size(), MSG_NOSIGNAL) < 0 || ::write(begun, "1", 1) != 1) ::_exit(1);
    while (::send(link, text.data(), text.size(), MSG_NOSIGNAL) >= 0) ::usleep(10000);
    ::_exit(0);
  }

  pid_t process_ = 0;
};

/// What a watch has said, and when.
class Told {
 public:
  WatchObserver observer() {
    return {[this](const GuardNews& news) {
              const std::lock_guard<std::mutex> lock(mutex_);
              news_.push_back(news);
              messages_ += news.message + "; ";
              if (news.kind == GuardNewsKind::Lost) lost_s_ = clock_.now();
            },
            [this] {
              const std::lock_guard<std::mutex> lock(mutex_);
              begun_s_ = clock_.now();
            },
            {}};
  }
  std::size_t count(GuardNewsKind kind) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return static_cast<std::size_t>(std::count_if(
        news_.begin(), news_.end(), [kind](const GuardNews& each) { return each.kind == kind; }));
  }
  std::string messages() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }
  double lost() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return lost_s_;
  }
  double begun() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return begun_s_;
  }

 private:
  mutable std::mutex mutex_;
  SteadyClock clock_;
  std::vector<GuardNews> news_;
  std::string messages_;
  double lost_s_ = 0.0;
  double begun_s_ = 0.0;
};

std::string milliseconds(std::vector<double> delays_s) {
  std::sort(delays_s.begin(), delays_s.end());
  const auto at = [&](double share) {
    const auto index = static_cast<std::size_t>(share * static_cast<double>(delays_s.size() - 1));
    return std::to_string(std::lround(delays_s[index] * 1e5) / 100.0).substr(0, 5);
  };
  return "median " + at(0.5) + " ms, 99 % within " + at(0.99) + " ms, worst " + at(1.0) + " ms";
}

int lossesToTry() {
  const char* const text = std::getenv("LAMINA_LOSSES");
  return text == nullptr ? 12 : std::max(1, std::atoi(text));
}

/// Losses at random instants. The figures are printed, and judged by nobody.
TEST(StreamerWatch, StopsTheMachineAfterEachDeathOfItsStreamer) {
  const LeftMachine machine("watch_deaths");
  const std::string socket = inTemporary("watch_deaths.pulse");
  Told told;
  const StreamerWatch watch(socket, {1.0, 0.0, 0.0, 0.5}, told.observer());
  const SteadyClock clock;
  std::mt19937 random(7);
  std::vector<double> noticed_s;
  std::vector<double> begun_s;
  std::vector<double> off_s;
  const int losses = lossesToTry();
  for (int i = 0; i < losses; ++i) {
    machine.heat();
    PulsingProcess streamer(socket, machine.pulse());
    ::usleep(static_cast<useconds_t>(random() % 50000));
    const double killed_s = clock.now();
    streamer.die();
    ASSERT_TRUE(comesTrue([&] { return machine->nozzleTarget() == 0.0 && machine->bedTarget() == 0.0; }))
        << "after " << i << " losses: " << told.messages();
    off_s.push_back(clock.now() - killed_s);
    ASSERT_TRUE(
        comesTrue([&] { return told.count(GuardNewsKind::Stopped) == static_cast<std::size_t>(i + 1); }));
    ASSERT_EQ(told.count(GuardNewsKind::Lost), static_cast<std::size_t>(i + 1));
    noticed_s.push_back(told.lost() - killed_s);
    begun_s.push_back(told.begun() - killed_s);
  }
  std::cout << losses << " deaths; noticed: " << milliseconds(noticed_s)
            << "; first bytes of the stop sent: " << milliseconds(begun_s)
            << "; heaters off: " << milliseconds(off_s) << '\n';
  EXPECT_EQ(told.count(GuardNewsKind::NotStopped), 0U);
}

TEST(StreamerWatch, EndsAStreamerThatHangsAndStopsItsMachine) {
  const LeftMachine machine("watch_hangs");
  const std::string socket = inTemporary("watch_hangs.pulse");
  Told told;
  const StreamerWatch watch(socket, {0.3, 0.0, 0.0, 0.5}, told.observer());
  machine.heat();
  PulsingProcess streamer(socket, machine.pulse());
  ::usleep(100000);
  streamer.signal(SIGSTOP);
  EXPECT_TRUE(comesTrue([&] { return told.count(GuardNewsKind::Stopped) == 1; }));
  EXPECT_EQ(machine->nozzleTarget(), 0.0);
  EXPECT_TRUE(streamer.wasKilled());
}

/// Of one that stops by other means than a port, such as the controller of an arm.
TEST(StreamerWatch, HasAMachineStoppedByTheMeansGivenToIt) {
  const std::string socket = inTemporary("watch_means.pulse");
  Told told;
  WatchObserver observer = told.observer();
  std::atomic<int> heard{0};
  std::atomic<int> stops{0};
  observer.heard = [&](const MachinePulse& pulse) { heard += pulse.port.name == "/arm/follow" ? 1 : 0; };
  const MachineStopper stop = [&](const MachinePulse& machine, const std::function<void()>& begun) {
    begun();
    ++stops;
    return MachineStopReport{true, machine.firmware + " rests", true};
  };
  const StreamerWatch watch(socket, {1.0, 600.0, 0.0, 0.5}, std::move(observer), stop);
  PulsingProcess driver(socket, {true, {"/arm/follow", 0}, kFollowsTrajectories, "", false, true});
  ASSERT_TRUE(comesTrue([&] { return heard > 0; }));
  EXPECT_EQ(stops, 0);
  driver.die();
  ASSERT_TRUE(comesTrue([&] { return told.count(GuardNewsKind::Stopped) == 1; })) << told.messages();
  EXPECT_EQ(stops, 1);
  EXPECT_NE(told.messages().find("/arm/follow: follow_joint_trajectory rests"), std::string::npos)
      << told.messages();
}

TEST(StreamerWatch, LeavesTheMachineOfAStreamerAloneThatDiesAtRest) {
  const LeftMachine machine("watch_rest");
  const std::string socket = inTemporary("watch_rest.pulse");
  Told told;
  const StreamerWatch watch(socket, {1.0, 0.0, 0.0, 0.5}, told.observer());
  machine.heat();
  MachinePulse pulse = machine.pulse();
  pulse.is_at_work = false;
  {
    const PulsingProcess streamer(socket, pulse);
    ::usleep(100000);
  }
  ::usleep(300000);
  EXPECT_EQ(told.count(GuardNewsKind::Lost), 0U);
  EXPECT_EQ(machine->nozzleTarget(), 200.0);
}

TEST(StreamerWatch, TriesAMachineAgainThatWasAway) {
  const std::string socket = inTemporary("watch_away.pulse");
  Told told;
  const StreamerWatch watch(socket, {1.0, 0.0, 0.0, 0.2}, told.observer());
  {
    const PulsingProcess streamer(socket, {true, {inTemporary("watch_away"), 115200}, "marlin", "", false});
    ::usleep(100000);
  }
  ASSERT_TRUE(comesTrue([&] { return told.count(GuardNewsKind::NotStopped) == 1; }));
  const LeftMachine machine("watch_away");
  EXPECT_TRUE(comesTrue([&] { return told.count(GuardNewsKind::Stopped) == 1; }));
}

TEST(StreamerWatch, StopsAtItsEndAMachineWhoseGraceIsNotOver) {
  const LeftMachine machine("watch_ends");
  const std::string socket = inTemporary("watch_ends.pulse");
  Told told;
  {
    const StreamerWatch watch(socket, {1.0, 1000.0, 0.0, 0.5}, told.observer());
    machine.heat();
    {
      const PulsingProcess streamer(socket, machine.pulse());
      ::usleep(100000);
    }
    ASSERT_TRUE(comesTrue([&] { return told.count(GuardNewsKind::Lost) == 1; }));
    EXPECT_EQ(machine->nozzleTarget(), 200.0);
  }
  EXPECT_EQ(machine->nozzleTarget(), 0.0);
  EXPECT_EQ(told.count(GuardNewsKind::Stopped), 1U);
}

TEST(PulseLink, CarriesThePulsesOfAProcessAndItsEnd) {
  const std::string socket = inTemporary("link.pulse");
  PulseListener listener(socket);
  std::vector<HeardPulse> heard;
  const auto hears = [&](auto condition) {
    return comesTrue([&] {
      for (const HeardPulse& each : listener.wait(0.01)) heard.push_back(each);
      return !heard.empty() && condition(heard.back());
    });
  };
  {
    const PulseSender sender(socket, [] { return MachinePulse{true, {"/dev/x", 1}, "auto", "", false}; });
    EXPECT_TRUE(
        hears([](const HeardPulse& each) { return each.pulse && each.pulse->port.name == "/dev/x"; }));
    EXPECT_TRUE(comesTrue([&] { return sender.isHeard(); }));
  }
  EXPECT_TRUE(hears([](const HeardPulse& each) { return !each.pulse; }));
  EXPECT_EQ(heard.front().process, ::getpid());
}

TEST(PulseLink, FindsAListenerThatComesLater) {
  const std::string socket = inTemporary("late.pulse");
  const PulseSender sender(socket, [] { return MachinePulse{false, {"/dev/x", 1}, "auto", "", false}; });
  EXPECT_FALSE(sender.isHeard());
  PulseListener listener(socket);
  EXPECT_TRUE(comesTrue([&] { return !listener.wait(0.01).empty(); }));
}

TEST(PulseLink, HasOneListener) {
  const std::string socket = inTemporary("one.pulse");
  const PulseListener listener(socket);
  EXPECT_THROW(PulseListener second(socket), DeviceError);
  EXPECT_THROW(PulseListener(std::string(200, 'x')), InvalidInput);
  EXPECT_THROW(PulseSender(std::string(200, 'x'), {}), InvalidInput);
}

TEST(PulseLink, OfNoSocketSendsNothing) {
  PulseSender sender("", {});
  sender.send();
  EXPECT_TRUE(sender.isHeard());
}

}  // namespace
}  // namespace lamina
