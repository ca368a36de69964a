// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/process_support.hpp"

#include <algorithm>
#include <variant>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Supported = const std::vector<ProcessElement>&;

bool holds(Supported supported, ProcessElement element) {
  return std::find(supported.begin(), supported.end(), element) != supported.end();
}

/// Marks ask nothing of who takes them.
bool asksNothing(const ToolpathEvent& event) { return std::holds_alternative<PartMark>(event); }

ProcessElement elementOf(const ToolpathEvent& event) {
  if (std::holds_alternative<Dwell>(event)) return ProcessElement::Dwell;
  if (std::holds_alternative<FanShare>(event)) return ProcessElement::Fan;
  if (std::holds_alternative<OperatorPause>(event)) return ProcessElement::Pause;
  return std::get<MachineCode>(event).moves_axes ? ProcessElement::MovingCode : ProcessElement::Code;
}

std::string describe(const ToolpathEvent& event) {
  return elementOf(event) == ProcessElement::MovingCode ? "code that moves axes" : nameOf(event);
}

/// What of a path is not supported, in words; empty if all is.
std::string unsupported(const Path& path, Supported supported) {
  if (path.tool != 0 && !holds(supported, ProcessElement::Tool)) return "tool " + std::to_string(path.tool);
  if (!path.values.empty() && !holds(supported, ProcessElement::Value))
    return "process value '" + path.values.front().name + "'";
  for (const PathEvent& placed : path.events)
    if (!asksNothing(placed.event) && !holds(supported, elementOf(placed.event)))
      return describe(placed.event);
  return {};
}

}  // namespace

void requireSupported(const Toolpath& toolpath, Supported supported, const std::string& by) {
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
    const auto& paths = toolpath.layers[l].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      const std::string what = unsupported(paths[p], supported);
      if (!what.empty())
        throw InvalidInput("toolpath layer " + std::to_string(l) + ", path " + std::to_string(p) + ": " +
                           what + " cannot be carried by " + by);
    }
  }
  for (const ToolpathEvent& event : toolpath.events_at_end)
    if (!asksNothing(event) && !holds(supported, elementOf(event)))
      throw InvalidInput("end of the toolpath: " + describe(event) + " cannot be carried by " + by);
}

}  // namespace lamina
