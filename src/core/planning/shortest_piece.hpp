// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// What is shorter is no piece of a run that is divided [mm].
constexpr double kShortestPiece = 1e-3;

}  // namespace lamina
