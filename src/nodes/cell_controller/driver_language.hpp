// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "followed_job.hpp"

namespace lamina {

/// How what trajectory_driver says is to be taken.
ExecutorLanguage driverLanguage();

}  // namespace lamina
