// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Asks the system to run the calling thread before all ordinary ones: in real time where the user may
/// (`ulimit -r`), else with a better nice value where that is allowed (`ulimit -e`), and in turns as short as
/// the kernel gives (Linux 6.12), for which it wakes up sooner. Needs no rights, and says nothing where they
/// lack.
void preferThisThread();

}  // namespace lamina
