// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Number of bytes at which writers hand their text on.
constexpr std::size_t kTextPiece = 1U << 16;

}  // namespace lamina
