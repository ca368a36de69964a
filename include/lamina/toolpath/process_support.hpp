// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Kind of element that a toolpath can contain besides motions and beads: an event (MovingCode is a
/// `MachineCode` that moves axes), a tool other than the first, or a process value.
enum class ProcessElement : std::uint8_t { Dwell, Fan, Pause, Code, MovingCode, Tool, Value };

/// Refuses a toolpath with elements that are not supported.
/// @param by  who processes the toolpath, for the message: "drop programs"
/// @throws InvalidInput naming layer, path and the element
void requireSupported(const Toolpath& toolpath, const std::vector<ProcessElement>& supported,
                      const std::string& by);

}  // namespace lamina
