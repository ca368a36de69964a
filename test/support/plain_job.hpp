// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/job/slice_job.hpp"

namespace lamina::test {

/// Walls and infill, without what jobs lay, wait for and cool by default so that parts come off a printer
/// whole.
inline JobSettings plainSettings() {
  JobSettings settings;
  settings.planning = {};
  settings.cooling = {};
  settings.fan = {};
  return settings;
}

inline SliceJob plainJob() {
  SliceJob job;
  job.settings = plainSettings();
  return job;
}

}  // namespace lamina::test
