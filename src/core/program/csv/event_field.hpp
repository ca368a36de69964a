// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/toolpath/toolpath_event.hpp"

namespace lamina {

/// An event as part of a CSV field: "dwell=2.5", "fan=0.4", "pause=insert nuts", "code=M117 hot",
/// "moving_code=G28". Bytes other than printable ASCII, and , | % are written as % and two hexadecimal
/// digits.
std::string toField(const ToolpathEvent& event);

/// The event that a field states.
/// @throws InvalidInput if the field states none
ToolpathEvent eventFromField(std::string_view field);

}  // namespace lamina
