// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath that `writeCsv` wrote. What the rows do not hold is taken thus: a layer lies at the height of
/// its highest deposited waypoint (along its normal) and is as high as its first deposited bead; layers whose
/// number is skipped have no paths; nothing is retracted.
///
/// @throws InvalidProgram if the header differs, a row has another number of fields or one that is no number,
///   the rows' layers or paths are out of order, or a closed path does not return to its start; names the
///   line
/// @throws InvalidInput   if `validate` refuses the whole
Toolpath readCsv(std::string_view text, const std::string& part_name);

}  // namespace lamina
