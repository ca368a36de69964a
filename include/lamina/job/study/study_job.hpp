// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/optimisation/evaluation.hpp"
#include "lamina/optimisation/evaluation_journal.hpp"
#include "lamina/optimisation/surrogate.hpp"
#include "lamina/study/study.hpp"
#include "lamina/study/study_outcome.hpp"

namespace lamina {

/// A study to be run.
struct StudyJob {
  Study study;
  std::string output;  ///< folder; made if it is not there
  EarlierJournal earlier = EarlierJournal::GoOn;
};

/// How far a study is.
struct StudyState {
  int index = 0;  ///< generation, from 0; or iteration, from 1
  int evaluations = 0;
  int failed = 0;
  /// The best value of each objective for itself: in the front, or among feasible samples; they may belong to
  /// different points. Empty if none is feasible.
  std::vector<double> best;
  double hypervolume = 0.0;  ///< of a front
};

/// Reported of each generation or iteration when it is done.
using StudyListener = std::function<void(const StudyState&)>;

/// Files that a study leaves in its folder.
struct StudyFiles {
  std::string journal;        ///< every evaluation as it was done: by it a run that was stopped goes on
  std::string front_journal;  ///< the same of what is measured once more for the front
  std::string front;          ///< front.csv
  std::string evaluations;    ///< evaluations.csv, with errors
  std::string chosen;         ///< chosen.yaml
  std::string picture;        ///< front.png: the first two objectives
  std::string report;         ///< report.html
};

StudyFiles studyFilesIn(const std::string& folder);

/// Runs a study: tries points, decides, and writes what it found. A run that is stopped leaves the journal,
/// and the same call goes on with it and ends as if it had not been stopped.
///
/// @param fit    of surrogates; may be empty for NSGA-II
/// @param outer  tries the points instead of this machine's threads, with the responses of the study's
///   measurement; may be null
/// @param listener  may be empty
/// @throws InvalidConfig, InvalidMesh, FileError before anything is tried; InvalidInput if the journal is
///   that of another study, or an output is a file that the study reads; what the searches throw; Cancelled
StudyOutcome runStudy(const StudyJob& job, const SurrogateFit& fit, Evaluator* outer,
                      const StudyListener& listener, Progress& progress);

}  // namespace lamina
