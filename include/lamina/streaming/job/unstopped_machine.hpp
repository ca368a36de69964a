// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

// Remarks at the end of a failure's message, where the machine has not been told to stop with the job.

/// For a machine that receives lines: the link was not back in time for the safe stop.
constexpr const char* kLinkNotBack =
    "; the link did not come back, so that the machine was not commanded to stop: look after it";

/// For a print server that is out of reach.
constexpr const char* kMayStillPrint = "; it may still be printing, and hot: look after it";

}  // namespace lamina
