// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Writers hand their text on once it has so many bytes.
constexpr std::size_t kTextPiece = 1U << 16;

}  // namespace lamina
