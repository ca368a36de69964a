// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/grbl/grbl_overriding.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace lamina {
namespace {

int nextPercent(int percent, int byte, int as_programmed) {
  constexpr std::array<int, 4> kSteps = {10, -10, 1, -1};
  if (byte == as_programmed) return 100;
  return std::clamp(percent + kSteps[static_cast<std::size_t>(byte - as_programmed - 1)], 10, 200);
}

}  // namespace

bool GrblOverriding::note(char byte) {
  const bool is_extended = static_cast<unsigned char>(byte) >= 0x80;
  if (is_extended) bytes_.insert(byte);
  return is_extended;
}

void GrblOverriding::apply() {
  constexpr int kFeed = 0x90;
  constexpr int kRapid = 0x95;
  constexpr int kSpindle = 0x99;
  constexpr std::array<int, 3> kRapids = {100, 50, 25};
  if (bytes_.empty()) return;
  for (const char given : std::exchange(bytes_, {})) {
    const int byte = static_cast<unsigned char>(given);
    if (byte >= kFeed && byte < kRapid) percents_.feed = nextPercent(percents_.feed, byte, kFeed);
    if (byte >= kRapid && byte < kRapid + 3)
      percents_.rapid = kRapids[static_cast<std::size_t>(byte - kRapid)];
    if (byte >= kSpindle && byte < kSpindle + 5)
      percents_.spindle = nextPercent(percents_.spindle, byte, kSpindle);
  }
  reports_left_ = 1;
}

void GrblOverriding::reset() {
  percents_ = {};
  reports_left_ = 1;
}

std::string GrblOverriding::takeReport() {
  constexpr int kReportsBetween = 10;
  if (--reports_left_ > 0) return {};
  reports_left_ = kReportsBetween;
  return "|Ov:" + std::to_string(percents_.feed) + "," + std::to_string(percents_.rapid) + "," +
         std::to_string(percents_.spindle);
}

}  // namespace lamina
