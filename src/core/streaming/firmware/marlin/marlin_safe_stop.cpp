// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a job sends to leave the machine safe, and how it is known to be.
#include <algorithm>

#include "streaming/firmware/marlin/marlin_job.hpp"
#include "streaming/firmware/marlin/stop_commands.hpp"

namespace lamina {
namespace {

// Lines under way when a job is aborted must not be taken for those of the safe stop.
constexpr std::uint64_t kSafeStopGap = 1000;

}  // namespace

void MarlinJob::prepareSafeStop(double now) {
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  safe_stop_latest_ = now + std::max(settings_.safe_stop_timeout_s, settings_.blocking_timeout_s);
  // With a journal beyond the program: who goes on with the job must not take these numbers for its lines'.
  const std::uint64_t end = line_base_ > 0 ? line_base_ + record_.status.lines_total : 0;
  base_ = std::max(feed_.end(), end) + kSafeStopGap;
  feed_ = LineFeed(sourceOf(safeStop(*firmware_, outputs_, settings_)), base_ + 1);
  sent_.clear();
  settle_until_ = 0.0;
  must_send_one_ = false;
}

bool MarlinJob::isSafe(const ReportedTemperatures& temperatures) const {
  if (settings_.keep_heaters_on) return true;
  const bool is_bed_off = !temperatures.bed_c || temperatures.bed_target_c == 0.0;
  return temperatures.nozzle_target_c == 0.0 && is_bed_off && temperatures.highest_target_c == 0.0;
}

}  // namespace lamina
