// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/job/voids/void_job.hpp"

namespace lamina {

/// Refuses what looks like the part of another program, or one at the wrong place: filled, its voids would be
/// runs in the air. At most a fifth of the deposit may lie outside of the part, along the border of the part
/// at least 70 % as much must be covered as everywhere, and the boxes of the deposit must on the median take
/// half the area of those of the part's layers.
/// @throws InvalidInput telling the figures
void requirePlausible(const Toolpath& program, const VoidReport& report, const VoidJob& job);

}  // namespace lamina
