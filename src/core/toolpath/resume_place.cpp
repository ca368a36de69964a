// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/resume_place.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/confirmed_place.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {
namespace {

constexpr double kWhole = 1e-3;  // mm that is no bead

}  // namespace

void describe(SettingsSchema& schema, ToolpathResumeSettings& settings) {
  schema.number("resume.overlap_mm", settings.overlap_mm, {0.0, 100.0},
                "How far before the place where it was cut off a job is resumed, along the bead.");
  schema.number("resume.tolerance_mm", settings.tolerance_mm, Bounds::above(0.0, 10.0),
                "Distance of the nozzle from the toolpath within which it stands where the job was cut off.");
}

bool ResumePlace::isAllLaid() const { return begin_mm >= total_mm - kWhole; }

ResumePlace resumePlace(const LaidBeads& beads, const ReportedProgress& reported,
                        const std::optional<Eigen::Isometry3d>& nozzle,
                        const ToolpathResumeSettings& settings) {
  if (!std::isfinite(reported.laid_mm) || reported.laid_mm < 0.0)
    throw InvalidInput("the length of beads reported as laid is " + numberText(reported.laid_mm) +
                       " mm; expected 0 mm or more");
  ResumePlace place;
  place.total_mm = beads.total();
  place.laid_mm = std::min(reported.laid_mm, place.total_mm);
  if (nozzle) {
    const auto found = beads.find(*nozzle, {reported.laid_mm, reported.behind_mm, reported.ahead_mm,
                                            reported.most_rise_mm, settings.tolerance_mm});
    place.is_found = found.has_value();
    if (found) place.laid_mm = *found;
    place.unreported_mm3 = std::max(0.0, beads.volume(place.laid_mm) - beads.volume(reported.laid_mm));
  }
  // Lengths in metres on their way here lose a last digit: nothing is left to lay for that.
  if (place.laid_mm >= place.total_mm - kWhole) place.laid_mm = place.total_mm;
  // Of a toolpath that is handed over to its end, the controller runs the rest by itself.
  const bool is_known = place.is_found || place.laid_mm >= place.total_mm;
  const double least_mm = is_known ? place.laid_mm : std::max(0.0, place.laid_mm - reported.behind_mm);
  place.begin_mm = std::max(beads.beadStart(least_mm), least_mm - settings.overlap_mm);
  place.heading_for = beads.headingFor(place.begin_mm);
  return place;
}

void requireConfirmed(const ResumePlace& place, double begin_mm) {
  if (std::abs(place.begin_mm - begin_mm) <= kConfirmedPlace) return;
  throw InvalidInput("the job would begin after " + numberText(place.begin_mm) +
                     " mm of its beads, and a person has confirmed " + numberText(begin_mm) +
                     " mm; expected the same to " + numberText(kConfirmedPlace) +
                     " mm: look at the place, and confirm it anew");
}

std::string toText(const ResumePlace& place) {
  // What encoders report varies, and the place is the same.
  const auto mm = [](double value) { return numberText(std::round(10.0 * value) / 10.0) + " mm"; };
  if (place.isAllLaid()) return "all " + mm(place.total_mm) + " of its beads are laid";
  const std::string known =
      place.is_found ? "the nozzle came to rest on it after " + mm(place.laid_mm) + " of its beads, of " +
                           mm(place.total_mm) + "; whether the last bead was laid up to there is not known"
                     : "after " + mm(place.laid_mm) + " of its beads, of " + mm(place.total_mm) +
                           ", it was reported last; where the nozzle stands does not show how much was "
                           "laid after that, which is laid a second time";
  return known + "; it begins after " + mm(place.begin_mm) + ", on the way to " + toText(place.heading_for);
}

}  // namespace lamina
