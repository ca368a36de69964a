// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace lamina {

/// Who somebody is towards the cell.
enum class WebRole : std::uint8_t {
  Viewer,      ///< sees everything
  Sender,      ///< a slicer: sees the state, uploads
  Operator,    ///< also releases, starts, holds, stops
  Maintenance  ///< also modes, tokens, the loop
};

/// What a request needs.
enum class WebRight : std::uint8_t {
  None,      ///< nobody has to be known
  SeeState,  ///< state of the unit, without queue and records
  SeeAll,
  Upload,
  Hold,  ///< as Operate; but viewers on the loopback interface may hold
  Operate,
  Maintain
};

const char* toString(WebRole role);    ///< "operator"
const char* toString(WebRight right);  ///< "operate"

/// @throws InvalidInput naming those that there are
WebRole webRole(const std::string& name);

/// Whether a role has a right. Hold counts as Operate here.
bool mayDo(WebRole role, WebRight right);

}  // namespace lamina
