// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// What makes a tour shorter by less is rounding, and could be undone and redone for ever [mm].
constexpr double kLeastGain = 1e-9;

}  // namespace lamina
