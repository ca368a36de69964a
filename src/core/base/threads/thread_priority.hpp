// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Raises the priority of the calling thread above ordinary ones: to real time if the user may (`ulimit -r`),
/// else to a better nice value if that is allowed (`ulimit -e`), with the shortest time slices of the kernel
/// (Linux 6.12), which let it wake up sooner. Without these rights it has no effect.
/// @return whether it runs in real time
bool preferThisThread();

}  // namespace lamina
