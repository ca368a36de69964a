// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// How the journal of an earlier run is used.
enum class EarlierJournal {
  GoOn,         ///< points that it holds are not tried again
  RetryFailed,  ///< of the points that it holds, only those that failed are tried again
  BeginAnew,    ///< the journal is emptied, even if it is of another study
};

/// The file in which evaluations are recorded.
struct JournalSettings {
  std::string path;  ///< empty: only in memory
  /// Text that changes with anything on which responses depend, apart from the point.
  std::string fingerprint;
  EarlierJournal earlier = EarlierJournal::GoOn;
};

/// An evaluator that tries no point twice, and records each evaluation in a file, the journal, as soon as it
/// is done. With the journal of a run that was stopped, the same search with the same seed continues from
/// there, with the result of an uninterrupted run.
///
/// The file has one JSON object a line. The first is the header: fingerprint, variables, and names of the
/// responses. Each further line is an evaluation: "point", and "responses" or "error". A last line without
/// line break is dropped, as the run was stopped while it was written.
class JournalledEvaluator final : public Evaluator {
 public:
  /// @param inner  tries points that are not in the journal; must outlive this
  /// @throws InvalidInput if the file is the journal of another study (the message says how they differ), or
  ///   a line is not valid (it is named); FileError if it cannot be read or written, or another run writes it
  JournalledEvaluator(Evaluator& inner, const DesignSpace& space, const JournalSettings& settings);
  ~JournalledEvaluator() override;

  const std::vector<std::string>& responseNames() const override;

  /// `done` is also called with evaluations from the journal. A point that is given more than once is tried
  /// once.
  /// @throws InvalidInput if a point is outside the space; FileError if the journal cannot be written, now or
  ///   at an earlier call; Error if the inner evaluator returns another number of evaluations; Cancelled
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener& done,
                                   Progress& progress) override;

  /// All evaluations in the journal: those read, in the order of the file, then those of points tried since,
  /// in the order in which they were done.
  std::vector<Evaluation> evaluations() const;

 private:
  class Journal;
  Evaluator& inner_;
  DesignSpace space_;
  std::unique_ptr<Journal> journal_;
};

}  // namespace lamina
