// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace lamina {

/// A device of the process that is switched on and off.
enum class ProcessChannel : std::uint8_t { Laser, Wire, Powder, Gas };

/// The name of a channel: "laser", "wire", "powder", "gas".
const char* toString(ProcessChannel channel);

/// The switching of a channel at an instant.
struct ProcessEvent {
  double time_s = 0.0;
  ProcessChannel channel = ProcessChannel::Laser;
  bool is_on = false;
};

}  // namespace lamina
