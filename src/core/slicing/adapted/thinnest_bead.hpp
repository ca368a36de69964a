// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Least height of a bead as a share of the layer's height: where the layer runs out on the one below,
/// nothing lower is deposited.
constexpr double kThinnest = 0.25;

}  // namespace lamina
