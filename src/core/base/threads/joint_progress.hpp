// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include "lamina/base/progress.hpp"

namespace lamina {

/// The progress of one stage whose parts run at the same time. The reported fraction never falls.
class JointProgress {
 public:
  /// @param whole     receives the reports; must outlive this
  /// @param stage     name under which progress is reported, whatever the parts call it
  JointProgress(Progress& whole, std::string stage);

  /// The progress of one part, to be used by one thread; it must not outlive the joint progress.
  class Part final : public Progress {
   public:
    /// @param share  share of the stage, 0 to 1; the shares of all parts sum to 1
    Part(JointProgress& joint, double share) : joint_(&joint), share_(share) {}
    void report(const std::string& stage, double fraction) override;
    bool isCancelled() const override { return joint_->whole_->isCancelled(); }

   private:
    JointProgress* joint_;
    double share_;
    double done_ = 0.0;
  };

 private:
  void add(double share);

  Progress* whole_;
  std::string stage_;
  std::mutex mutex_;
  double done_ = 0.0;
  double reported_ = 0.0;
};

}  // namespace lamina
