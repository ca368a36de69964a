// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Memory [bytes] that this process can still take without swapping, as the machine reports (MemAvailable) or
/// its control group allows, whichever is less. Infinite if neither reports.
double availableMemory();

/// Most memory [bytes] that this process ever held resident; 0 if the machine does not report.
double peakMemory();

}  // namespace lamina
