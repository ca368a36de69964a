// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// How many lines a second go over a pseudo-terminal to the emulated machine, and to a peer that answers at
// once; and how long the next line takes after an ok with one line under way.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "lamina/streaming/client/stream_session.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"

namespace lamina {
namespace {

constexpr int kLines = 50000;

StreamableProgram zigzag() {
  std::string text = "G90\nM82\nG1 F6000\n";
  for (int i = 0; i < kLines - 3; ++i) {
    text += "G1 X" + std::to_string(100 + i % 97) + ".123 Y" + std::to_string(i % 89) + ".456 E" +
            std::to_string(0.01 * i) + "\n";
  }
  return StreamableProgram::fromText("zigzag", text);
}

/// Firmware that does nothing but count lines and say ok.
class InstantPeer {
 public:
  InstantPeer() : machine_(::posix_openpt(O_RDWR | O_NOCTTY)) {
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
    thread_ = std::thread([this] { run(); });
  }
  ~InstantPeer() {
    is_over_ = true;
    thread_.join();
    ::close(machine_);
    ::close(host_);
  }
  InstantPeer(const InstantPeer&) = delete;
  InstantPeer& operator=(const InstantPeer&) = delete;

  const std::string& path() const { return path_; }
  /// From each answer to the next arrival [s].
  std::vector<double> waits() const { return waits_; }

 private:
  using Clock = std::chrono::steady_clock;

  void run() {
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

  int machine_;
  int host_ = -1;
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

void measureOkToNextLine(benchmark::State& state, const StreamJournal& journal) {
  const StreamableProgram program = zigzag();
  std::vector<double> waits;
  for (auto _ : state) {
    const InstantPeer peer;
    stream(program, peer.path(), 1, state, journal);
    waits = peer.waits();
  }
  std::sort(waits.begin(), waits.end());
  state.counters["p50_us"] = 1e6 * waits[waits.size() / 2];
  state.counters["p99_us"] = 1e6 * waits[waits.size() * 99 / 100];
  state.counters["worst_us"] = 1e6 * waits.back();
  state.SetItemsProcessed(state.iterations() * kLines);
}

void okToNextLine(benchmark::State& state) { measureOkToNextLine(state, {}); }
BENCHMARK(okToNextLine)->Unit(benchmark::kMillisecond)->UseRealTime();

void okToNextLineWithJournal(benchmark::State& state) {
  measureOkToNextLine(state, beginJournal(kJournal));
  std::remove(kJournal);
}
BENCHMARK(okToNextLineWithJournal)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
