// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// An order of what is in clouds, the same for the same bits: negative, zero or positive as the first comes
/// before, is the same as, or comes after the second. Their stamps do not count.
int compared(const SensedCloud& a, const SensedCloud& b);

}  // namespace lamina
