// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What a toolpath can ask of a process besides motions and deposited material.
enum class ProcessElement : std::uint8_t { Dwell, Fan, Pause, Code, MovingCode, Tool, Value };

/// Refuses a toolpath that asks for more than its taker can do.
/// @param by  who takes it, for the message: "drop programs"
/// @throws InvalidInput naming layer, path and the element; a tool other than the first is an element
void requireSupported(const Toolpath& toolpath, const std::vector<ProcessElement>& supported,
                      const std::string& by);

}  // namespace lamina
