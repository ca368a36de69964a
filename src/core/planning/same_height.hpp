// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Heights closer to each other than this count as equal [mm]: borders of layers are rounded sums.
constexpr double kSameHeight = 1e-6;

}  // namespace lamina
