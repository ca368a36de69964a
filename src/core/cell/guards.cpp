// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/guards.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr int kZoneTaken = 1204;
constexpr int kBlocked = 1206;
constexpr char kZoneReported[] = "the PLC reports another robot in the zone";
constexpr double kSmallestDisk = 1024.0 * 1024 * 1024;  // [bytes]

std::vector<UnmetGuard> notGiven(const PlcInterlocks& plc) {
  std::vector<UnmetGuard> unmet;
  if (!plc.is_plate_there) unmet.push_back({1201, "the PLC reports no build plate"});
  if (!plc.is_plate_clamped) unmet.push_back({1202, "the PLC reports the build plate not clamped"});
  std::vector<std::string> missing;
  if (!plc.has_material) missing.emplace_back("material");
  if (!plc.has_gas) missing.emplace_back("gas");
  if (!plc.has_cooling) missing.emplace_back("cooling");
  if (!plc.has_vacuum) missing.emplace_back("vacuum");
  if (!missing.empty()) unmet.push_back({1205, "the PLC reports no " + listed(missing)});
  return unmet;
}

std::vector<UnmetGuard> forbidden(const PlcInterlocks& plc) {
  std::vector<UnmetGuard> unmet;
  if (plc.is_zone_taken) unmet.push_back({kZoneTaken, kZoneReported});
  if (plc.is_blocked) unmet.push_back({kBlocked, "the PLC reports that parts cannot be taken away"});
  if (plc.is_emergency_stop_pressed) unmet.push_back({1312, "the PLC reports the emergency stop pressed"});
  return unmet;
}

void append(std::vector<UnmetGuard>& unmet, const std::vector<UnmetGuard>& more) {
  unmet.insert(unmet.end(), more.begin(), more.end());
}

std::vector<UnmetGuard> inOrder(std::vector<UnmetGuard> unmet) {
  std::stable_sort(unmet.begin(), unmet.end(),
                   [](const UnmetGuard& a, const UnmetGuard& b) { return a.code < b.code; });
  return unmet;
}

std::string roomLeft(std::optional<double> free_bytes) {
  if (!free_bytes) return "the journal's disk does not say how much it has left";
  return "the journal's disk has " + std::to_string(std::lround(*free_bytes / 1048576.0)) + " MiB left";
}

}  // namespace

bool isHeard(const PlcInterlocks& plc, PlcNeed need) {
  return plc.is_alive || (plc.is_beating && need == PlcNeed::None);
}

std::vector<UnmetGuard> againstPlc(const PlcInterlocks& plc, PlcNeed need) {
  const bool is_required = need == PlcNeed::Required;
  if (!plc.is_alive && is_required)
    return {{2101, "the PLC's heartbeat does not come; its interlocks count as not given"}};
  std::vector<UnmetGuard> unmet;
  if (is_required) append(unmet, notGiven(plc));
  if (isHeard(plc, need))
    append(unmet, forbidden(plc));
  else if (plc.is_silent)
    unmet.push_back({kZoneTaken, whyZoneIsTaken(plc, need)});
  return inOrder(std::move(unmet));
}

std::string whyZoneIsTaken(const PlcInterlocks& plc, PlcNeed need) {
  if (isHeard(plc, need)) return plc.is_zone_taken ? kZoneReported : "";
  // Nobody tells another robot's coming: what was free when the PLC was heard last need not be free now.
  if (plc.is_silent) return "the PLC is silent, so that its zone counts as taken; expected its heartbeat";
  if (need == PlcNeed::Required)
    return "the PLC, which is required, is not heard, so that its zone counts as taken; expected its "
           "heartbeat";
  return "";
}

std::vector<UnmetGuard> againstStart(const StartConditions& found) {
  std::vector<UnmetGuard> unmet;
  if (found.mode != kProduction)
    unmet.push_back({1301, "the mode is " + std::to_string(found.mode) + "; expected 1 (Production)"});
  if (found.job.empty()) unmet.push_back({1302, "no job of the queue is allowed to start; release one"});
  if (!found.unready.empty())
    unmet.push_back({1303, "the start-up is not done: " + listed(found.unready, "; ")});
  if (!found.job.empty() && !found.machine_differences.empty())
    unmet.push_back({1304, "the program of '" + found.job + "' was checked for another machine: " +
                               listed(found.machine_differences, "; ") + "; queue it anew"});
  else if (!found.job.empty() && !found.is_checked)
    unmet.push_back({1304, "the program of '" + found.job + "' was not checked for this machine"});
  if (found.needs_loop && !found.loop_fault.empty())
    unmet.push_back({1305, "the height loop may not run: " + found.loop_fault});
  if (!found.is_part_removed) unmet.push_back({1203, "the last part was not confirmed as removed"});
  append(unmet, againstPlc(found.plc, found.plc_need));
  if (found.needs_loop && !found.clock_fault.empty()) unmet.push_back({8003, found.clock_fault});
  if (!found.free_bytes.has_value() || *found.free_bytes < kSmallestDisk)
    unmet.push_back({7002, roomLeft(found.free_bytes) + "; expected at least 1024 MiB"});
  if (!found.torn.empty())
    unmet.push_back({7101, "no longer with the hash they were released with: " + listed(found.torn)});
  return inOrder(std::move(unmet));
}

std::vector<UnmetGuard> againstContinuing(const ContinueConditions& found) {
  std::vector<UnmetGuard> unmet;
  if (!found.is_position_known) unmet.push_back({1306, "the position is not known; home or prove it first"});
  if (!found.out_of_band.empty()) unmet.push_back({1307, "out of band: " + listed(found.out_of_band)});
  for (const UnmetGuard& guard : againstPlc(found.plc, found.plc_need))
    if (guard.code != kBlocked) unmet.push_back(guard);  // a part under way is in nobody's way
  if (!found.has_master) unmet.push_back({8002, "the ROS master does not answer"});
  return inOrder(std::move(unmet));
}

}  // namespace lamina
