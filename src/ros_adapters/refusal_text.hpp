// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

/// What a request asks a node for, as its log names it.
struct RequestName {
  std::string verb;     ///< "slice"
  std::string subject;  ///< part, program, toolpath id or study
  std::string output;   ///< file that would have been written; empty for none
};

/// The line that a node logs where a request fails: "cannot slice 'cube.stl' into 'cube.gcode':
/// InvalidConfig: ...". An empty subject is named so.
std::string refusalText(const RequestName& request, const Failure& failure);

}  // namespace lamina
