// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Smaller gaps are not worth a run of their own, in squared pitches.
constexpr double kLeastGap = 0.3;

}  // namespace lamina
