// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Memory [bytes] that this process can still use without swapping: the lesser of what the system reports
/// (MemAvailable) and what its control group leaves. Infinite if neither is known.
double availableMemory();

/// Greatest resident memory [bytes] of this process so far; 0 if the system does not report it.
double peakMemory();

}  // namespace lamina
