// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "progress/service_progress.hpp"

#include <ros/init.h>

namespace lamina {

bool ServiceProgress::isCancelled() const { return !ros::ok(); }

}  // namespace lamina
