// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// A number as messages show it, with at most six significant digits and no trailing zeros: "0.2", "1e-07",
/// "nan". The same in every locale.
std::string numberText(double value);

}  // namespace lamina
