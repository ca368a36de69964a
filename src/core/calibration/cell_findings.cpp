// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/cell_findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/calibration/calibration_program.hpp"

namespace lamina {
namespace {

/// @throws InvalidInput naming all
std::string oneOf(const std::string& what, const std::string& method, const std::vector<std::string>& known) {
  if (method.empty()) return known.front();
  if (std::find(known.begin(), known.end(), method) != known.end()) return method;
  std::string names;
  for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
  throw InvalidInput(what + " cannot be calibrated by '" + method + "'; expected one of " + names);
}

void requireValues(const char* what, const std::vector<double>& values, std::size_t expected) {
  if (!values.empty() && values.size() != expected)
    throw InvalidConfig(std::string(what) + " of the pyramid has " + std::to_string(values.size()) +
                        " values; expected " + std::to_string(expected) + ", or none");
  for (const double value : values)
    if (!std::isfinite(value))
      throw InvalidConfig(std::string(what) + " of the pyramid has the value " + numberText(value) +
                          " mm; expected a finite one");
}

PyramidTarget pyramidTarget(const KnownPyramid& known, const CalibrationSettings& settings) {
  requireValues("the size", known.size_mm, 3);
  requireValues("the middle", known.touched_mm, 2);
  requireValues("the top", known.top_mm, 1);
  PyramidTarget target;
  if (!known.size_mm.empty()) {
    target.base_mm = known.size_mm[0];
    target.top_mm = known.size_mm[1];
    target.height_mm = known.size_mm[2];
  }
  if (!(target.base_mm > target.top_mm && target.top_mm > 0.0 && target.height_mm > 0.0))
    throw InvalidConfig("the pyramid is " + numberText(target.base_mm) + " mm wide at its base, " +
                        numberText(target.top_mm) + " mm at its top and " + numberText(target.height_mm) +
                        " mm high; expected a base wider than the top, and all above 0");
  Point3 at(settings.x_mm, settings.y_mm, 0.0);
  target.is_place_known = !known.touched_mm.empty();
  if (target.is_place_known) at.head<2>() = Point2(known.touched_mm[0], known.touched_mm[1]);
  target.is_top_known = !known.top_mm.empty();
  if (target.is_top_known) at.z() = known.top_mm[0] - target.height_mm;
  target.bed_from_pyramid.translation() = at;
  return target;
}

template <class... Values>
std::string worded(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// What shows nothing would replace what an earlier recording has shown.
void requireAnyDirection(const SensorPoseFit& fit, const SensorPoseSettings& how) {
  if (!std::all_of(fit.is_kept.begin(), fit.is_kept.end(), [](bool is_kept) { return is_kept; })) return;
  throw InvalidInput(
      "none of the six directions of the sensor's place is determined, by " + std::to_string(fit.points) +
      " points " + numberText(fit.rms_mm) +
      " mm rms off their target; expected the target in view, from poses that show one of them to " +
      numberText(how.max_sigma_mm) + " mm or " + numberText(how.max_sigma_deg) + " deg");
}

}  // namespace

std::string timeMethod(const std::string& method) {
  return oneOf("the time offset", method, {"bobbing", "edge", "overlap"});
}

FoundTime findTime(const SensorRecording& recording, const std::string& method,
                   const Eigen::Isometry3d& about, const CalibrationSettings& settings,
                   const std::string& date) {
  const std::string by = timeMethod(method);
  FoundTime found;
  if (by == "bobbing") {
    found.fit = offsetByBobbing(recording, settings.search_s);
  } else {
    PassComparison comparison;
    comparison.search_s = settings.search_s;
    comparison.nozzle_from_sensor = about;
    found.fit = offsetByPasses(recording, comparison);
  }
  found.time = {
      found.fit.offset_s, found.fit.spread_s, found.fit.scatter_s, found.fit.drift_s_per_min, {by, date}};
  return found;
}

SensorTarget sensorTarget(const std::string& method, const KnownPyramid& pyramid,
                          const CalibrationSettings& settings) {
  const std::string by = oneOf("the place of the sensor", method, {"cross", "bed", "plane", "pyramid"});
  if (by == "pyramid") return pyramidTarget(pyramid, settings);
  if (by == "cross")
    return CrossTarget{crossBeads(settings), settings.bead_width_mm, settings.bead_height_mm};
  return PlaneTarget{by == "bed"};
}

FoundPose findPose(const std::vector<SensorView>& views, const Eigen::Isometry3d& about, double time_offset_s,
                   const CalibrationSettings& settings, const CalibrationOrigin& origin) {
  SensorPoseSettings how;
  how.time_offset_s = time_offset_s;
  how.max_sigma_mm = settings.max_sigma_mm;
  how.max_sigma_deg = settings.max_sigma_deg;
  how.noise_mm = settings.noise_mm;
  FoundPose found;
  found.fit = fitSensorPose(views, about, how);
  requireAnyDirection(found.fit, how);
  found.pose.nozzle_from_sensor = found.fit.nozzle_from_sensor;
  found.pose.spread.assign(found.fit.sigma.begin(), found.fit.sigma.end());
  found.pose.not_found = directionsNotFound(found.fit);
  found.pose.origin = origin;
  found.not_observable = observability(found.fit, how);
  return found;
}

CalibratedPose withFormer(const FoundPose& found, const std::optional<CalibratedPose>& former) {
  CalibratedPose pose = found.pose;
  if (!former) return pose;
  SensorPoseFit both = found.fit;
  for (std::size_t i = 0; i < both.is_kept.size(); ++i) {
    if (!both.is_kept[i] || former->spread[i] == 0.0) continue;
    both.is_kept[i] = false;
    pose.spread[i] = former->spread[i];
  }
  pose.not_found = directionsNotFound(both);
  return pose;
}

FoundFeeder findFeeder(const SensorRecording& scan, const Eigen::Isometry3d& about, double time_offset_s,
                       const CalibrationSettings& settings, const std::string& date) {
  const FeederSteps steps = feederSteps(settings);
  FoundFeeder found;
  found.fit = fitFeeder(steps, beadSections(scan, about, time_offset_s, steps), settings.feeder_mm_s);
  found.feeder = {found.fit.dead_time_s,
                  found.fit.dead_time_spread_s,
                  found.fit.lag_s,
                  found.fit.lag_spread_s,
                  {"bead", date}};
  return found;
}

double timeOffsetOf(const Calibration& cell) { return cell.time ? cell.time->offset_s : 0.0; }

std::vector<std::string> inWords(const FoundTime& found) {
  const TimeOffset& fit = found.fit;
  std::vector<std::string> sentences = {
      worded("time offset %.3f ms by %s: true time is the stamp less that", fit.offset_s * 1e3,
             found.time.origin.method.c_str()),
      worded("spread      %.3f ms; %.3f ms from piece to piece of %zu; drift %.3f ms/min", fit.spread_s * 1e3,
             fit.scatter_s * 1e3, fit.pieces_s.size(), fit.drift_s_per_min * 1e3),
      worded("agreement   %.4f over %zu profiles", fit.agreement, fit.profiles)};
  if (found.time.origin.method == "overlap" && !fit.is_skew_separable)
    sentences.emplace_back(
        "caution     swaths lie to one side only: a turn of the sensor's line counts as time");
  return sentences;
}

std::vector<std::string> inWords(const FoundPose& found) {
  const CalibratedPose& pose = found.pose;
  const Eigen::Vector3d at = pose.nozzle_from_sensor.translation();
  std::vector<std::string> sentences = {
      worded("sensor      at %.3f, %.3f, %.3f mm of the nozzle, by %s", at.x(), at.y(), at.z(),
             pose.origin.method.c_str()),
      worded("spread      %.4f, %.4f, %.4f mm; %.4f, %.4f, %.4f deg", pose.spread[0], pose.spread[1],
             pose.spread[2], pose.spread[3], pose.spread[4], pose.spread[5]),
      worded("points      %.4f mm rms from their target", found.fit.rms_mm)};
  for (const std::string& sentence : found.not_observable) sentences.push_back("kept        " + sentence);
  return sentences;
}

std::vector<std::string> inWords(const FoundFeeder& found) {
  const FeederFit& fit = found.fit;
  return {worded("dead time   %.3f s, spread %.3f s", fit.dead_time_s, fit.dead_time_spread_s),
          worded("lag         %.3f s, spread %.3f s", fit.lag_s, fit.lag_spread_s),
          worded("sections    %zu, %.2f %% rms off; they follow the steps by %.3f", fit.sections,
                 100.0 * fit.rms, fit.gain),
          worded("shift       %.3f mm of the scan against the program", fit.shift_mm)};
}

}  // namespace lamina
