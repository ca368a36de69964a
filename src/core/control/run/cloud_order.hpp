// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/control/run/stamped_events.hpp"

namespace lamina {

/// Order of clouds by the bits of their content, without regard to their time stamps: negative, zero or
/// positive if `a` comes before, equals or comes after `b`.
int compared(const SensedCloud& a, const SensedCloud& b);

}  // namespace lamina
