// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath that `writeCsv` wrote. What the rows do not state is assumed: the height `z_mm` of a layer is
/// that of its highest deposited waypoint, along the normal of the layers; its thickness is the height of its
/// first deposited bead; a layer whose number is skipped has no paths; no travel is retracted.
///
/// @throws InvalidProgram naming the line, if the header does not begin as `kCsvHeader`, a row has another
///   number of fields or a field that cannot be read, layers or paths are out of order, rows of one path
///   contradict each other, or a closed path does not return to its start
/// @throws InvalidInput  if `validate` refuses the toolpath
Toolpath readCsv(std::string_view text, const std::string& part_name);

}  // namespace lamina
