// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Least area of a gap that is worth a run of its own, in squared pitches.
constexpr double kLeastGap = 0.3;

}  // namespace lamina
