// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/study/study_outcome.hpp"

namespace lamina {

/// A picture of a report.
struct ReportPicture {
  std::string png;          ///< contents of the PNG file
  std::string description;  ///< in words, for the caption
};

/// Diagrams of each pair of objectives against each other, with all evaluated points, the front and the
/// chosen point. Empty if there are fewer than two objectives.
std::vector<ReportPicture> frontPictures(const Study& study, const StudyOutcome& outcome);

/// Diagrams of the progress of the search. For NSGA-II: hypervolume and best values over generations. For a
/// surrogate: errors of prediction over iterations, and predictions against measurements.
std::vector<ReportPicture> progressPictures(const Study& study, const StudyOutcome& outcome);

/// The report of a study as one HTML page: the question, the chosen point, the front, published values for
/// comparison, failed points and their reasons. It contains its pictures, has no scripts and refers to no
/// other file; text of the study is escaped.
std::string studyReport(const Study& study, const StudyOutcome& outcome);

}  // namespace lamina
