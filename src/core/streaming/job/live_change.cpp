// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/live_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/job_override.hpp"
#include "streaming/job/decimal.hpp"

namespace lamina {
namespace {

struct KindOfChange {
  std::string_view name;
  LiveSetting setting;
  double least;
  double most;
  std::string_view unit;
  bool is_whole;
};

/// By the bounds that driven toolpaths have, in percent.
constexpr KindOfChange overrideOf(std::string_view name, LiveSetting setting, OverrideKind kind,
                                  bool is_whole) {
  constexpr double kPercent = 100.0;
  return {name, setting, kPercent * boundsOf(kind).least, kPercent * boundsOf(kind).most, " %", is_whole};
}

constexpr std::array<KindOfChange, 8> kKinds = {
    {overrideOf("feed", LiveSetting::Feed, OverrideKind::Feed, false),
     overrideOf("flow", LiveSetting::Flow, OverrideKind::Flow, false),
     {"babystep", LiveSetting::Babystep, -0.5, 0.5, " mm", false},
     {"cancel_part", LiveSetting::CancelPart, 0.0, 9999.0, "", true},
     {"pause_at_layer", LiveSetting::PauseAtLayer, 0.0, 1e6, "", true},
     {"rapid", LiveSetting::Rapid, 25.0, 100.0, " %", true},
     {"spindle", LiveSetting::Spindle, 10.0, 200.0, " %", true},
     overrideOf("power", LiveSetting::Power, OverrideKind::Power, true)}};

}  // namespace

std::string nameOf(LiveSetting setting) {
  const auto* const kind = std::find_if(kKinds.begin(), kKinds.end(),
                                        [&](const KindOfChange& known) { return known.setting == setting; });
  return kind == kKinds.end() ? std::string() : std::string(kind->name);
}

std::string notOf(const std::string& machine, LiveSetting setting) {
  return machine + " has no " + nameOf(setting);
}

LiveChange liveChange(const std::string& name, double value) {
  std::string names;
  for (const KindOfChange& kind : kKinds) {
    if (kind.name != name) {
      names += (names.empty() ? "" : ", ") + std::string(kind.name);
      continue;
    }
    const bool is_good =
        value >= kind.least && value <= kind.most && (!kind.is_whole || value == std::round(value));
    if (is_good) return {kind.setting, value};
    throw InvalidInput(name + " is " + decimal(value) + std::string(kind.unit) + "; must be " +
                       (kind.is_whole ? "a whole number " : "") + "from " + decimal(kind.least) + " to " +
                       decimal(kind.most) + std::string(kind.unit));
  }
  throw InvalidInput("'" + name + "' cannot be changed while a job runs; expected one of " + names);
}

}  // namespace lamina
