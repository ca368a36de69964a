// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Least length of a piece when a run is divided [mm].
constexpr double kShortestPiece = 1e-3;

}  // namespace lamina
