// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace lamina {

enum class ProcessChannel : std::uint8_t { Laser, Wire, Powder, Gas };

/// "laser", "wire", "powder", "gas".
const char* toString(ProcessChannel channel);

/// An instant at which something is switched.
struct ProcessEvent {
  double time_s = 0.0;
  ProcessChannel channel = ProcessChannel::Laser;
  bool is_on = false;
};

}  // namespace lamina
