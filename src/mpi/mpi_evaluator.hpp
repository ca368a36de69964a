// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// The processes that `mpirun` started, while it lives. One in a process. Where the leader's ends, the others
/// leave `servePoints`.
class MpiSession {
 public:
  /// @throws Error if MPI does not start, or not for threads
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool isLeader() const { return rank_ == 0; }

 private:
  int rank_ = 0;
  int size_ = 1;
};

/// Tries points on all other processes, each of which gets a new one as soon as it is free. The leader,
/// process 0, only hands out; where there is no other process it measures on its threads. Results are in the
/// order of the points, so they do not depend on the number of processes.
///
/// Used in the leader, while the others are in `servePoints`. A point that is
/// being measured when the search is cancelled is given up; those that were done have been reported.
class MpiEvaluator final : public Evaluator {
 public:
  /// @param measure  for a leader without others
  MpiEvaluator(const MpiSession& session, std::vector<std::string> response_names, PointMeasurement measure);

  const std::vector<std::string>& responseNames() const override { return alone_.responseNames(); }
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener& done,
                                   Progress& progress) override;

 private:
  int size_;
  ParallelEvaluator alone_;
};

/// Measures what the leader asks for until its session ends.
/// @param make  makes the measurement; if it throws, the leader's `evaluate` ends with InvalidInput naming
///   which process cannot measure and why, and no point counts as failed by it
void servePoints(const std::function<PointMeasurement()>& make);

}  // namespace lamina
