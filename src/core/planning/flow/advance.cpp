// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <string>
#include <utility>

#include "lamina/base/number_text.hpp"
#include "lamina/planning/flow/flow.hpp"
#include "planning/flow/role_advances.hpp"

namespace lamina {
namespace {

std::string advanceLine(AdvanceWord word, double advance_s) {
  const std::string value = numberText(advance_s);
  switch (word) {
    case AdvanceWord::Klipper:
      return "SET_PRESSURE_ADVANCE ADVANCE=" + value;
    case AdvanceWord::RepRapFirmware:
      return "M572 D0 S" + value;
    case AdvanceWord::Marlin:
      break;
  }
  return "M900 K" + value;
}

}  // namespace

void addAdvance(Toolpath& toolpath, const FlowSettings& settings) {
  if (!hasAdvance(settings)) return;
  const std::array<double, kPathRoles> advances = advancesOf(settings);
  double last_s = -1.0;
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      const double advance_s = advances[static_cast<std::size_t>(path.role)];
      if (std::exchange(last_s, advance_s) == advance_s) continue;
      PathEvent change;
      change.event.emplace<MachineCode>(MachineCode{advanceLine(settings.advance_word, advance_s), false});
      path.events.insert(path.events.begin(), std::move(change));
    }
}

}  // namespace lamina
