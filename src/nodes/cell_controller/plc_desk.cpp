// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plc_desk.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/clock.hpp"
#include "names.hpp"

namespace lamina {
namespace {

PlcReport reportOf(const lamina_msgs::PlcInputs& said) {
  PlcReport report;
  report.heartbeat = static_cast<PlcHeartbeat>(
      std::min<std::uint8_t>(said.watchdog, static_cast<std::uint8_t>(PlcHeartbeat::Abandoned)));
  report.on_silence = static_cast<WatchdogAction>(
      std::min<std::uint8_t>(said.on_silence, static_cast<std::uint8_t>(WatchdogAction::Stop)));
  report.is_plate_written = said.is_plate_told != 0;
  report.is_part_removed = said.is_part_removed != 0;
  report.is_guard_closed = said.is_guard_closed != 0;
  PlcInterlocks& interlocks = report.interlocks;
  interlocks.is_alive = report.heartbeat == PlcHeartbeat::Good;
  interlocks.is_beating = said.is_beating != 0;
  interlocks.has_material = said.has_material != 0;
  interlocks.has_gas = said.has_gas != 0;
  interlocks.has_cooling = said.has_cooling != 0;
  interlocks.has_vacuum = said.has_vacuum != 0;
  interlocks.is_plate_there = said.is_plate_there != 0;
  interlocks.is_plate_clamped = said.is_plate_clamped != 0;
  interlocks.is_zone_taken = said.is_zone_taken != 0;
  interlocks.is_blocked = said.is_blocked != 0;
  interlocks.is_emergency_stop_pressed = said.is_emergency_stop_pressed != 0;
  return report;
}

}  // namespace

PlcDesk::PlcDesk(ros::NodeHandle node, const PlcWatchSettings& settings, std::function<void()> heard)
    : heard_(std::move(heard)), watch_(settings) {
  said_.speed = 1.0;
  subscriber_ = node.subscribe(names::kPlcInputs, 100, &PlcDesk::onSaid, this);
}

void PlcDesk::onSaid(const lamina_msgs::PlcInputsConstPtr& said) {
  hear(*said);
  heard_();
}

void PlcDesk::hear(const lamina_msgs::PlcInputs& said) {
  const bool is_same_link = said.linked == said_.linked;
  if (is_same_link && said.sequence < said_.sequence) return;
  said_ = said;
  watch_.hear(reportOf(said), SteadyClock().now());
}

}  // namespace lamina
