// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/decimals.hpp"

namespace lamina {

/// A number in G-code, to a thousandth: "95", "-0.05".
inline std::string decimal(double value) { return trimmedDecimals(value, 3); }

}  // namespace lamina
