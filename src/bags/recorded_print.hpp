// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "lamina/control/run/loop_run.hpp"
#include "loop/loop_feed.hpp"

namespace lamina {

/// A bag and how it was read.
struct BagFigures {
  double recorded_s = 0.0;  ///< from the first to the last message
  std::uint64_t messages = 0;
};

/// What is done with a print of a bag.
struct PrintReceivers {
  std::function<void(const LoopRun&)> begins;                 ///< with its toolpath
  std::function<void(const LoopRun&, const LoopNews&)> news;  ///< in their order
  std::function<void(const LoopRun&, const FeedCounts&)> ends;
};

/// Runs the loop over the prints of a bag as the node height_controller does, without a master: over
/// `toolpath`, `profile`, `/tf`, `/tf_static`, and `applied_correction` where it was recorded. Memory is that
/// of the bag's index and of one layer.
/// @param space  namespace in which the topics were recorded; empty for none
/// @throws FileError if it is no bag, or broken
BagFigures runRecordedPrints(const std::string& path, const std::string& space,
                             const LoopRunSettings& settings, const PrintReceivers& receivers);

}  // namespace lamina
