// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/startup/startup_settings.hpp"

namespace lamina {

/// Effect of the loss of a prerequisite on the step that was done after it.
enum class OnLoss : std::uint8_t {
  Spreads,  ///< the step is lost too
  Stays,    ///< the step remains done
};

/// A step that must be Done or Skipped before another one begins.
struct Prerequisite {
  StartupStep step = StartupStep::PowerOn;
  std::string because;  ///< the reason, in words
  OnLoss on_loss = OnLoss::Spreads;
};

/// A step of a sequence, and its prerequisites.
struct SequencedStep {
  StartupStep step = StartupStep::PowerOn;
  std::vector<Prerequisite> after;  ///< prerequisites, all of them earlier in the sequence
  bool is_skipped = false;
};

/// Makes the sequence that the settings describe; empty if there is none.
///
/// @throws InvalidConfig naming key and reason if a name is unknown or given twice, a step precedes one that
///   it needs or that `startup.after_*` names for it, a step needs a missing step, a setting is out of its
///   bounds, the machine is not asked for its state, or a machine that switches the vacuum does not report it
std::vector<SequencedStep> makeStartupSequence(const StartupSettings& settings);

}  // namespace lamina
