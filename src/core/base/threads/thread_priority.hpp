// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Raises the priority of the calling thread: to real time if the user may do so (`ulimit -r`), otherwise to
/// a better nice value if that is allowed (`ulimit -e`), together with the shortest time slices of the kernel
/// (Linux 6.12), which let the thread wake up sooner. Without these rights it has no effect.
/// @return whether the thread has real-time priority
bool preferThisThread();

}  // namespace lamina
