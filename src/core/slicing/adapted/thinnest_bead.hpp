// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Part of a layer's height below which nothing is deposited where it runs out on the one below.
constexpr double kThinnest = 0.25;

}  // namespace lamina
