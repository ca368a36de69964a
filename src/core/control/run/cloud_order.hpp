// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/control/run/stamped_events.hpp"

namespace lamina {

/// Compares clouds by the bits of their content, without their stamps: negative, zero or positive if the
/// first comes before, equals or comes after the second.
int compared(const SensedCloud& a, const SensedCloud& b);

}  // namespace lamina
