// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/loop_state.hpp"

namespace lamina {

const char* toString(LoopState state) {
  switch (state) {
    case LoopState::Off:
      return "off";
    case LoopState::Identifying:
      return "identifying";
    case LoopState::Active:
      return "active";
    case LoopState::Coasting:
      return "coasting";
    case LoopState::Open:
      return "open";
    case LoopState::Blocked:
      return "blocked";
  }
  return "unknown";
}

bool isCorrecting(LoopState state) { return state == LoopState::Active || state == LoopState::Coasting; }

}  // namespace lamina
