// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "followed_job.hpp"

namespace lamina {

/// How messages of trajectory_driver are interpreted.
ExecutorLanguage driverLanguage();

}  // namespace lamina
