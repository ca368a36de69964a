// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/log.hpp"

namespace lamina {

/// A sink that passes the core's log lines to rosconsole.
LogSink rosLog();

}  // namespace lamina
