// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// How many lines a second go over a pseudo-terminal to the emulated machine, and to a peer that answers at
// once; and how long the next line takes after an ok with one line under way.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "lamina/streaming/emulator/emulated_machine.hpp"
#include "lamina/streaming/session/stream_session.hpp"

namespace lamina {
namespace {

constexpr int kLines = 50000;

StreamableProgram zigzag(int lines = kLines) {
  std::string text = "G90\nM82\nG1 F6000\n";
  for (int i = 0; i < lines - 3; ++i) {
    text += "G1 X" + std::to_string(100 + i % 97) + ".123 Y" + std::to_string(i % 89) + ".456 E" +
            std::to_string(0.01 * i) + "\n";
  }
  return StreamableProgram::fromText("zigzag", text);
}

/// Firmware runs on a processor of its own: where that is allowed, the peer waits for nobody.
void runAheadOfAll() {
  sched_param parameters{};
  parameters.sched_priority = sched_get_priority_max(SCHED_FIFO);
  ::sched_setscheduler(0, SCHED_FIFO, &parameters);
}

/// While it lives, threads that this one begins may not raise their priority, as those of any user.
class AsAnyUser {
 public:
  AsAnyUser() {
    ::syscall(SYS_capget, &header_, rights_.data());
    std::array<__user_cap_data_struct, 2> fewer = rights_;
    fewer[0].effective &= ~(1U << CAP_SYS_NICE);
    ::syscall(SYS_capset, &header_, fewer.data());
  }
  ~AsAnyUser() { ::syscall(SYS_capset, &header_, rights_.data()); }
  AsAnyUser(const AsAnyUser&) = delete;
  AsAnyUser& operator=(const AsAnyUser&) = delete;

 private:
  __user_cap_header_struct header_{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> rights_{};
};

/// By what the peer is reached. What comes from a terminal, a pseudo-terminal too, is passed on by a thread
/// of the kernel that has no priority, so that on a busy machine the kernel's scheduler is measured there.
enum class PeerLink { Terminal, Tcp };

/// Firmware that does nothing but count lines and say ok, at once unless it is given time.
class InstantPeer {
 public:
  /// @param line  how long it takes to run one
  explicit InstantPeer(PeerLink link = PeerLink::Terminal, std::chrono::microseconds line = {})
      : line_(line) {
    link == PeerLink::Tcp ? listen() : openTerminal();
    thread_ = std::thread([this] { run(); });
  }
  ~InstantPeer() {
    is_over_ = true;
    thread_.join();
    for (const int descriptor : {machine_, host_, listener_})
      if (descriptor >= 0) ::close(descriptor);
  }
  InstantPeer(const InstantPeer&) = delete;
  InstantPeer& operator=(const InstantPeer&) = delete;

  const std::string& path() const { return path_; }
  /// From each answer to the next arrival [s].
  std::vector<double> waits() const { return waits_; }

 private:
  using Clock = std::chrono::steady_clock;

  void openTerminal() {
    machine_ = ::posix_openpt(O_RDWR | O_NOCTTY);
    ::grantpt(machine_);
    ::unlockpt(machine_);
    std::array<char, 128> name{};
    ::ptsname_r(machine_, name.data(), name.size());
    path_ = name.data();
    host_ = ::open(name.data(), O_RDWR | O_NOCTTY);
    termios options{};
    ::tcgetattr(host_, &options);
    ::cfmakeraw(&options);
    ::tcsetattr(host_, TCSANOW, &options);
  }

  void listen() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
    if (::bind(listener_, reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
        ::listen(listener_, 1) != 0)
      throw std::runtime_error("cannot listen on the loopback interface");
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    path_ = "tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  }

  void run() {
    runAheadOfAll();
    if (listener_ >= 0) {
      machine_ = ::accept(listener_, nullptr, nullptr);
      const int at_once = 1;
      ::setsockopt(machine_, IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
    }
    std::array<char, 4096> buffer{};
    std::string line;
    while (!is_over_) {
      pollfd poll{machine_, POLLIN, 0};
      if (::poll(&poll, 1, 50) <= 0) continue;
      const ssize_t size = ::read(machine_, buffer.data(), buffer.size());
      if (size <= 0) continue;
      if (has_answered_) waits_.push_back(std::chrono::duration<double>(Clock::now() - answered_).count());
      std::string answer;
      for (const char byte : std::string_view(buffer.data(), static_cast<std::size_t>(size))) {
        if (byte != '\n') {
          line += byte;
        } else {
          answer += answerTo(line);
          line.clear();
        }
      }
      if (answer.empty()) continue;
      if (line_.count() > 0) std::this_thread::sleep_for(line_);
      answered_ = Clock::now();
      has_answered_ = ::write(machine_, answer.data(), answer.size()) > 0;
    }
  }

  std::string answerTo(const std::string& line) {
    if (line.find("M105") != std::string::npos) return "Resend: " + std::to_string(taken_ + 1) + "\nok\n";
    const std::size_t base = line.find("M110 N");
    if (base != std::string::npos) {
      taken_ = std::strtoull(line.c_str() + base + 6, nullptr, 10);
    } else if (line.front() == 'N') {
      ++taken_;
    }
    return "ok\n";
  }

  std::chrono::microseconds line_;
  int machine_ = -1;
  int host_ = -1;
  int listener_ = -1;
  std::string path_;
  std::uint64_t taken_ = 0;
  std::vector<double> waits_;
  Clock::time_point answered_;
  bool has_answered_ = false;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

/// A progress file beside where the benchmark runs, on a disk and not in memory.
constexpr const char* kJournal = "streaming_bench.progress";

void stream(const StreamableProgram& program, const std::string& port, int window_lines,
            benchmark::State& state, const StreamJournal& journal = {}) {
  StreamSettings settings;
  settings.temperature_interval_s = 0;
  settings.window_lines = window_lines;
  const StreamSession session(program, settings, {port, 115200}, {}, {{}, journal});
  session.waitFor(600.0);
  if (session.status().state != PackmlState::Complete)
    state.SkipWithError(session.status().failure.message.c_str());
}

void linesToEmulatedMachine(benchmark::State& state) {
  const StreamableProgram program = zigzag();
  EmulatedSettings settings;
  settings.speed_up = 0.0;
  const EmulatedMachine machine(settings, {}, {}, {});
  for (auto _ : state) stream(program, machine.pty(), 4, state);
  state.SetItemsProcessed(state.iterations() * kLines);
}
BENCHMARK(linesToEmulatedMachine)->Unit(benchmark::kMillisecond)->UseRealTime();

void linesToInstantPeer(benchmark::State& state) {
  const StreamableProgram program = zigzag();
  for (auto _ : state) {
    const InstantPeer peer;
    stream(program, peer.path(), 4, state);
  }
  state.SetItemsProcessed(state.iterations() * kLines);
}
BENCHMARK(linesToInstantPeer)->Unit(benchmark::kMillisecond)->UseRealTime();

void linesToInstantPeerWithJournal(benchmark::State& state) {
  const StreamableProgram program = zigzag();
  for (auto _ : state) {
    const InstantPeer peer;
    stream(program, peer.path(), 4, state, beginJournal(kJournal));
  }
  std::remove(kJournal);
  state.SetItemsProcessed(state.iterations() * kLines);
}
BENCHMARK(linesToInstantPeerWithJournal)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The peer of a measurement, and the lines that it gets.
struct Pace {
  PeerLink link = PeerLink::Terminal;
  std::chrono::microseconds line{0};
  int lines = kLines;
};
constexpr int kPacedLines = 5000;
constexpr Pace kTerminal{};
constexpr Pace kTcp{PeerLink::Tcp};
// Motions of a millisecond, as short as printers take them.
constexpr Pace kPacedTcp{PeerLink::Tcp, std::chrono::microseconds(1000), kPacedLines};

/// @param with_peer  what the streamer's session does beside a peer that waits for it
template <class WithPeer>
void measureOkToNextLine(benchmark::State& state, const Pace& pace, WithPeer with_peer) {
  const StreamableProgram program = zigzag(pace.lines);
  std::vector<double> waits;
  for (auto _ : state) {
    const InstantPeer peer(pace.link, pace.line);
    with_peer(program, peer);
    waits = peer.waits();
  }
  std::sort(waits.begin(), waits.end());
  state.counters["p50_us"] = 1e6 * waits[waits.size() / 2];
  state.counters["p99_us"] = 1e6 * waits[waits.size() * 99 / 100];
  state.counters["p999_us"] = 1e6 * waits[waits.size() * 999 / 1000];
  state.counters["worst_us"] = 1e6 * waits.back();
  state.SetItemsProcessed(state.iterations() * pace.lines);
}

void okToNextLine(benchmark::State& state, const Pace& pace) {
  measureOkToNextLine(state, pace, [&](const StreamableProgram& program, const InstantPeer& peer) {
    stream(program, peer.path(), 1, state);
  });
}
BENCHMARK_CAPTURE(okToNextLine, terminal, kTerminal)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(okToNextLine, tcp, kTcp)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(okToNextLine, paced_tcp, kPacedTcp)->Unit(benchmark::kMillisecond)->UseRealTime();

/// On a machine that is busy with something else (stress-ng --cpu 8): what a user without rights gets.
void okToNextLineAsAnyUser(benchmark::State& state, const Pace& pace) {
  measureOkToNextLine(state, pace, [&](const StreamableProgram& program, const InstantPeer& peer) {
    const AsAnyUser fewer_rights;
    stream(program, peer.path(), 1, state);
  });
}
BENCHMARK_CAPTURE(okToNextLineAsAnyUser, terminal, kTerminal)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(okToNextLineAsAnyUser, tcp, kTcp)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(okToNextLineAsAnyUser, paced_tcp, kPacedTcp)->Unit(benchmark::kMillisecond)->UseRealTime();

void okToNextLineWithJournal(benchmark::State& state) {
  measureOkToNextLine(state, kTerminal, [&](const StreamableProgram& program, const InstantPeer& peer) {
    stream(program, peer.path(), 1, state, beginJournal(kJournal));
  });
  std::remove(kJournal);
}
BENCHMARK(okToNextLineWithJournal)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
