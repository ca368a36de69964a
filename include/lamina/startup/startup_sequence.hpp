// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/startup/startup_settings.hpp"

namespace lamina {

/// What the loss of a step means for one that was done after it.
enum class OnLoss : std::uint8_t {
  Spreads,  ///< that one is lost too
  Stays,    ///< it remains done
};

/// A step that must be satisfied before another.
struct Prerequisite {
  StartupStep step = StartupStep::PowerOn;
  std::string because;
  OnLoss on_loss = OnLoss::Spreads;
};

/// A step of a sequence and what must come before it.
struct SequencedStep {
  StartupStep step = StartupStep::PowerOn;
  std::vector<Prerequisite> after;  ///< all of them stand before it in the sequence
  bool is_skipped = false;
};

/// The sequence that the settings stand for; empty if there is none.
///
/// @throws InvalidConfig naming key and reason if a name is unknown or stands twice, the order contradicts
/// what a step needs or what `startup.after_*` says (which is about the order only, so that no cycle is
/// left), a step needs one that is missing, a rate is 0 or above its bound, or a machine that switches the
/// vacuum does not report it
std::vector<SequencedStep> makeStartupSequence(const StartupSettings& settings);

}  // namespace lamina
