// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Heights stated by programs that are closer than this count as equal [mm]: a tenth of the last decimal of
/// Z.
constexpr double kSameStatedHeight = 1e-4;

}  // namespace lamina
