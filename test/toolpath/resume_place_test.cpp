// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/resume_place.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

// A square of 4 x 10 mm, a travel of 0.2 mm, and a line of 10 mm.
ResumePlace placeOf(double reported_mm, const std::optional<Point3>& tip, double overlap_mm = 2.0) {
  std::optional<Eigen::Isometry3d> nozzle;
  if (tip) {
    nozzle = Eigen::Isometry3d::Identity();
    nozzle->translation() = *tip;
    nozzle->linear() = nozzleDown().toRotationMatrix();
  }
  ReportedProgress reported;
  reported.laid_mm = reported_mm;
  reported.behind_mm = 3.0;
  return resumePlace(LaidBeads(test::twoLayers()), reported, nozzle, {overlap_mm, 0.15});
}

TEST(ResumePlace, BeginsBeforeWhereTheNozzleCameToRest) {
  const ResumePlace place = placeOf(12.0, Point3(10, 7, 0.2));
  EXPECT_TRUE(place.is_found);
  EXPECT_DOUBLE_EQ(place.laid_mm, 17.0);
  EXPECT_DOUBLE_EQ(place.begin_mm, 15.0);
  EXPECT_EQ(place.heading_for, (WaypointIndex{0, 0, 2}));
  EXPECT_NEAR(place.unreported_mm3, 5.0 * crossSection({0.4, 0.2}), 1e-9);
  EXPECT_DOUBLE_EQ(placeOf(12.0, Point3(10, 7, 0.2), 0.0).begin_mm, 17.0);
  // A machine trails what is reported.
  EXPECT_DOUBLE_EQ(placeOf(17.5, Point3(10, 7, 0.2)).begin_mm, 15.0);
}

TEST(ResumePlace, BeginsBeforeWhatWasReportedIfTheNozzleWasMovedAway) {
  for (const std::optional<Point3>& tip : {std::optional<Point3>(), std::optional(Point3(10, 7, 30))}) {
    const ResumePlace place = placeOf(12.0, tip);
    EXPECT_FALSE(place.is_found);
    EXPECT_DOUBLE_EQ(place.begin_mm, 7.0) << "the overlap, and what the machine may trail";
  }
  EXPECT_NE(toText(placeOf(12.0, std::nullopt)).find("is laid a second time"), std::string::npos);
}

TEST(ResumePlace, NeverGoesBackBeyondItsBead) {
  EXPECT_DOUBLE_EQ(placeOf(44.0, std::nullopt).begin_mm, 40.0);
  EXPECT_DOUBLE_EQ(placeOf(41.0, std::nullopt).begin_mm, 36.0) << "it may not have ended the bead before";
  EXPECT_DOUBLE_EQ(placeOf(0.5, std::nullopt).begin_mm, 0.0);
  // On the travel the square is laid, to its end.
  EXPECT_DOUBLE_EQ(placeOf(39.0, Point3(0, 0, 0.3)).begin_mm, 40.0);
}

TEST(ResumePlace, IsRefusedIfAPersonHasConfirmedAnotherOne) {
  const ResumePlace place = placeOf(12.0, Point3(10, 7, 0.2));  // begins after 15 mm
  EXPECT_NO_THROW(requireConfirmed(place, 15.4));
  EXPECT_NO_THROW(requireConfirmed(place, 14.6));
  try {
    requireConfirmed(place, 12.25);
    ADD_FAILURE() << "it begins elsewhere";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(
        error.what(),
        "the job would begin after 15 mm of its beads, and a person has confirmed 12.25 mm; expected the "
        "same to 0.5 mm: look at the place, and confirm it anew");
  }
  EXPECT_THROW(requireConfirmed(place, 15.6), InvalidInput);
  EXPECT_THROW(requireConfirmed(place, std::nan("")), InvalidInput);
}

TEST(ResumePlace, KnowsAJobThatIsDone) {
  EXPECT_TRUE(placeOf(50.0, std::nullopt).isAllLaid());
  EXPECT_TRUE(placeOf(45.0, Point3(10, 0, 0.4)).isAllLaid());
  EXPECT_FALSE(placeOf(49.0, std::nullopt).isAllLaid());
  EXPECT_EQ(toText(placeOf(50.0, std::nullopt)), "all 50 mm of its beads are laid");
}

/// 50 mm that were written in metres, and read.
TEST(ResumePlace, LaysNothingAgainForALastDigit) {
  for (const double less_mm : {7.2e-15, 1e-6, 9e-4}) {
    EXPECT_TRUE(placeOf(50.0 - less_mm, std::nullopt).isAllLaid()) << less_mm;
    EXPECT_TRUE(placeOf(50.0 - less_mm, Point3(10, 0, 30)).isAllLaid()) << "lifted, " << less_mm;
    EXPECT_TRUE(placeOf(45.0, Point3(10.0 - less_mm, 0, 0.4)).isAllLaid()) << less_mm;
  }
  EXPECT_FALSE(placeOf(50.0 - 2e-3, std::nullopt).isAllLaid());
}

TEST(ResumePlace, RefusesALengthThatNothingCanHave) {
  for (const double laid_mm : {std::nan(""), std::numeric_limits<double>::infinity(), -0.5})
    EXPECT_THROW(placeOf(laid_mm, std::nullopt), InvalidInput) << laid_mm;
  try {
    placeOf(-0.5, std::nullopt);
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "the length of beads reported as laid is -0.5 mm; expected 0 mm or more");
  }
}

TEST(ResumePlace, StatesWhatIsNotKnown) {
  EXPECT_EQ(
      toText(placeOf(12.0, Point3(10, 7, 0.2))),
      "the nozzle came to rest on it after 17 mm of its beads, of 50 mm; whether the last bead was laid "
      "up to there is not known; it begins after 15 mm, on the way to layer 0, path 0, waypoint 2");
}

TEST(ResumePlace, IsStatedTheSameWhateverTheNoiseOfEncoders) {
  const std::string text = toText(placeOf(12.0, Point3(10, 7.2, 0.2)));
  EXPECT_NE(text.find("after 17.2 mm of its beads"), std::string::npos) << text;
  EXPECT_NE(text.find("it begins after 15.2 mm"), std::string::npos) << text;
  for (const double noise_mm : {-0.03, 0.0004, 0.02})
    EXPECT_EQ(toText(placeOf(12.0, Point3(10, 7.2 + noise_mm, 0.2))), text) << noise_mm;
}

}  // namespace
}  // namespace lamina
