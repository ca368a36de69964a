// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina::test {

/// Stands in for the node that inclines: its action `slow_incline` goes on until it is cancelled. A program
/// named die.gcode ends the process at once, as a crash does; deaf.gcode makes it hear no cancel; odd.gcode
/// is answered without a status.
int serveSlowly();

}  // namespace lamina::test
