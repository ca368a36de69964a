// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/study/study_outcome.hpp"

namespace lamina {

/// A picture and what it shows.
struct ReportPicture {
  std::string png;  ///< bytes of the file
  std::string description;
};

/// The costs of each pair of objectives against each other: what was tried, the front, what was chosen. Empty
/// with fewer than two objectives.
std::vector<ReportPicture> frontPictures(const Study& study, const StudyOutcome& outcome);

/// How the search went on: hypervolume and best values over generations, or errors of prediction over
/// iterations, and predictions against measurements.
std::vector<ReportPicture> progressPictures(const Study& study, const StudyOutcome& outcome);

/// One page that a person can read, print and send: what was asked, what was chosen, the front, what was
/// published beside it, what failed and why. HTML with its pictures inside, without scripts, nothing from
/// elsewhere; all text of the study stands as it is.
std::string studyReport(const Study& study, const StudyOutcome& outcome);

}  // namespace lamina
