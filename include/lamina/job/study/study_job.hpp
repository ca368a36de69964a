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

/// A request to run a study.
struct StudyJob {
  Study study;
  std::string output;                             ///< folder; made if it does not exist
  EarlierJournal earlier = EarlierJournal::GoOn;  ///< what is done with the journal of an earlier run
};

/// Progress of a study after a generation or an iteration.
struct StudyState {
  int index = 0;        ///< generation, from 0; or iteration, from 1
  int evaluations = 0;  ///< number of points tried so far
  int failed = 0;       ///< number of these that failed
  /// The best value of each objective by itself, in the front or among feasible samples; the values may
  /// belong to different points. Empty if no point is feasible.
  std::vector<double> best;
  double hypervolume = 0.0;  ///< hypervolume of the front; 0 for a search by surrogate
};

/// Called after each generation or iteration.
using StudyListener = std::function<void(const StudyState&)>;

/// Paths of the files that a study writes into its folder.
struct StudyFiles {
  std::string journal;        ///< every evaluation as it was done; a stopped run is continued from it
  std::string front_journal;  ///< the same for the second measurement at the points of the front
  std::string front;          ///< front.csv: the points of the front
  std::string evaluations;    ///< evaluations.csv: all points, with errors
  std::string chosen;         ///< chosen.yaml: configuration of the chosen point
  std::string picture;        ///< front.png: the first two objectives
  std::string report;         ///< report.html
};

StudyFiles studyFilesIn(const std::string& folder);

/// Runs a study: searches, chooses a point, and writes the results. A run that is stopped leaves the journal;
/// the same call continues from it and ends as if the run had not been stopped.
///
/// @param fit    fits surrogates; may be empty for NSGA-II
/// @param outer  tries the points instead of the threads of this computer, and returns the responses of the
///   study's measurement; may be null
/// @param listener  may be empty
/// @throws InvalidConfig, InvalidMesh, FileError before any point is tried
/// @throws InvalidInput if the journal is that of another study, or an output is a file that the study reads
/// @throws as the searches; Cancelled
StudyOutcome runStudy(const StudyJob& job, const SurrogateFit& fit, Evaluator* outer,
                      const StudyListener& listener, Progress& progress);

}  // namespace lamina
