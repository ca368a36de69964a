// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace lamina {

/// Role of a client.
enum class WebRole : std::uint8_t {
  Viewer,      ///< sees everything
  Sender,      ///< a slicer: sees the state of the unit, uploads
  Operator,    ///< sees everything, uploads, releases, starts, holds, stops
  Maintenance  ///< as an operator; also modes, tokens, the closed loop
};

/// Right that a request requires.
enum class WebRight : std::uint8_t {
  None,      ///< no identification needed
  SeeState,  ///< state of the unit, without queue and records
  SeeAll,
  Upload,
  Hold,  ///< as Operate, but viewers on the loopback interface have it too
  Operate,
  Maintain
};

/// Names as "operator" and "operate".
const char* toString(WebRole role);    ///< "operator"
const char* toString(WebRight right);  ///< "operate"

/// The role of that name.
/// @throws InvalidInput if there is no such role; lists the roles
WebRole webRole(const std::string& name);

/// Whether a role has a right. Hold is treated as Operate here.
bool mayDo(WebRole role, WebRight right);

}  // namespace lamina
