// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// What becomes of the journal of an earlier run.
enum class EarlierJournal {
  GoOn,         ///< what it has is not tried again
  RetryFailed,  ///< only what failed is tried again
  BeginAnew,    ///< it is emptied, whatever study it is of
};

/// Where evaluations are written down.
struct JournalSettings {
  std::string path;         ///< empty: only in memory
  std::string fingerprint;  ///< of all that the responses depend on besides the point
  EarlierJournal earlier = EarlierJournal::GoOn;
};

/// Tries no point twice, and writes down what came of each as soon as it is known. Over the journal of a run
/// that was stopped, the same search with the same seed goes on where it was and ends as if it had never
/// stopped.
///
/// The file has one JSON object a line. The first is the header: the fingerprint, the variables, the names of
/// the responses. Each of the others is an evaluation: "point", and "responses" or "error". A last line
/// without its end is dropped: the run was stopped while writing it.
class JournalledEvaluator final : public Evaluator {
 public:
  /// @param inner  tries what is not in the journal; must outlive this
  /// @throws InvalidInput if the file is the journal of another study (says in what they differ), or a line
  ///   is none of a journal (names it); FileError if it cannot be read or written, or another run writes it
  JournalledEvaluator(Evaluator& inner, const DesignSpace& space, const JournalSettings& settings);
  ~JournalledEvaluator() override;

  const std::vector<std::string>& responseNames() const override;

  /// Evaluations from the journal are asked to `done` too. A point that stands more than once is tried once.
  /// @throws InvalidInput if a point is outside the space; FileError if the journal cannot be written, now or
  ///   at an earlier call; Error if the inner evaluator answers another number of points; Cancelled
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener& done,
                                   Progress& progress) override;

  /// All evaluations in the journal: those read, in the order of the file, then those tried, as they came.
  std::vector<Evaluation> evaluations() const;

 private:
  class Journal;
  Evaluator& inner_;
  DesignSpace space_;
  std::unique_ptr<Journal> journal_;
};

}  // namespace lamina
