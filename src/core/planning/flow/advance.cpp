// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "lamina/base/number_text.hpp"
#include "lamina/planning/flow/flow.hpp"
#include "planning/flow/role_advances.hpp"

namespace lamina {
namespace {

/// What the firmware is told last.
struct StatedAdvance {
  std::uint32_t tool = 0;
  double advance_s = -1.0;
};

bool operator==(const StatedAdvance& a, const StatedAdvance& b) {
  return a.tool == b.tool && a.advance_s == b.advance_s;
}

/// Marlin and Klipper set that of the tool in use.
std::string advanceLine(AdvanceWord word, const StatedAdvance& stated) {
  const std::string value = numberText(stated.advance_s);
  switch (word) {
    case AdvanceWord::Klipper:
      return "SET_PRESSURE_ADVANCE ADVANCE=" + value;
    case AdvanceWord::RepRapFirmware:
      return "M572 D" + std::to_string(stated.tool) + " S" + value;
    case AdvanceWord::Dialect:
    case AdvanceWord::Marlin:
      break;
  }
  return "M900 K" + value;
}

}  // namespace

void addAdvance(Toolpath& toolpath, const FlowSettings& settings) {
  if (!hasAdvance(settings)) return;
  const std::array<double, kPathRoles> advances = advancesOf(settings);
  StatedAdvance last;
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      const StatedAdvance next{path.tool, advances[static_cast<std::size_t>(path.role)]};
      if (std::exchange(last, next) == next) continue;
      PathEvent change;
      change.event.emplace<MachineCode>(MachineCode{advanceLine(settings.advance_word, next), false});
      path.events.insert(path.events.begin(), std::move(change));
    }
}

}  // namespace lamina
