// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Sets any baud rate of a serial port, also one without a constant in termios, such as Marlin's 250000.
/// @throws std::system_error if the port does not support it
void setBaudRate(int descriptor, int baud);

}  // namespace lamina
