// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string_view>

namespace lamina {

/// Receives a text piece by piece, in order. Pieces may end within a line.
using TextSink = std::function<void(std::string_view piece)>;

}  // namespace lamina
