// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Sets any baud rate, also one without a constant in termios, such as Marlin's 250000.
/// @throws std::system_error if the port cannot do it
void setBaudRate(int descriptor, int baud);

}  // namespace lamina
