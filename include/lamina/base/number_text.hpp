// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// A number in a message, to six significant digits and no longer than they need: "0.2", "1e-07", "nan".
/// Alike in every locale.
std::string numberText(double value);

}  // namespace lamina
