// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

/// The wording by which a node's log names a request.
struct RequestName {
  std::string verb;     ///< "slice"
  std::string subject;  ///< part, program, toolpath id or study
  std::string output;   ///< file that the request would have written; empty for none
};

/// The line that a node logs if a request fails: "cannot slice 'cube.stl' into 'cube.gcode': InvalidConfig:
/// ...". An empty subject is written as "nothing named".
std::string refusalText(const RequestName& request, const Failure& failure);

}  // namespace lamina
