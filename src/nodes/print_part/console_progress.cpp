// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "console_progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace lamina {
namespace {

constexpr int kBarWidth = 30;

std::string bar(double fraction) {
  const int filled = static_cast<int>(kBarWidth * fraction);
  return "[" + std::string(static_cast<std::size_t>(filled), '#') +
         std::string(static_cast<std::size_t>(kBarWidth - filled), ' ') + "]";
}

}  // namespace

ConsoleProgress::ConsoleProgress() : is_terminal_(::isatty(STDOUT_FILENO) != 0) {}

void ConsoleProgress::show(const std::string& stage, double fraction, const std::string& detail) {
  const double within = std::clamp(fraction, 0.0, 1.0);
  const int percent = static_cast<int>(100.0 * within);
  const std::string line = is_terminal_
                               ? stage + " " + bar(within) + " " + std::to_string(percent) + " % " + detail
                               : stage + " " + std::to_string(percent / 10 * 10) + " %";
  if (line == drawn_) return;
  std::printf(is_terminal_ ? "\r\x1b[K%s" : "%s\n", line.c_str());
  std::fflush(stdout);
  drawn_ = line;
}

void ConsoleProgress::finish() {
  if (is_terminal_ && !drawn_.empty()) std::printf("\r\x1b[K");
  std::fflush(stdout);
  drawn_.clear();
}

}  // namespace lamina
