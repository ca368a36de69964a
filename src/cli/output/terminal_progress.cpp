// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/terminal_progress.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>

namespace lamina::cli {
namespace {

// A terminal that is closed hangs up: a machine must not be left hot for that.
constexpr std::array<int, 3> kStopSignals = {SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but a variable of this kind.
volatile std::sig_atomic_t was_interrupted = 0;

void interrupt(int) { was_interrupted = 1; }

/// Whether it is the signal of a terminal that is closed, and whoever started the command by nohup wants it
/// to go on then.
bool mayHangUp(int signal) {
  struct sigaction action {};
  return signal == SIGHUP && ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

TerminalProgress::TerminalProgress() : is_shown_(::isatty(STDERR_FILENO) != 0) {
  was_interrupted = 0;
  for (const int signal : kStopSignals)
    if (!mayHangUp(signal)) std::signal(signal, interrupt);
}

TerminalProgress::~TerminalProgress() {
  for (const int signal : kStopSignals)
    if (!mayHangUp(signal)) std::signal(signal, SIG_DFL);
  if (!drawn_.empty()) std::fputs("\r\x1b[K", stderr);
}

void TerminalProgress::report(const std::string& stage, double fraction) {
  if (!is_shown_) return;
  const std::string line = stage + " " + std::to_string(static_cast<int>(100.0 * fraction)) + " %";
  const std::lock_guard<std::mutex> lock(mutex_);
  if (line == drawn_) return;
  drawn_ = line;
  std::fprintf(stderr, "\r\x1b[K%s", line.c_str());
  std::fflush(stderr);
}

bool TerminalProgress::isCancelled() const { return was_interrupted != 0; }

}  // namespace lamina::cli
