// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Least shortening of a tour that counts [mm]. Less is rounding error: such changes could be undone and
/// redone for ever.
constexpr double kLeastGain = 1e-9;

}  // namespace lamina
