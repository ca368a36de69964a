// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "orientation/run_orientation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/orientation/lead_and_tilt.hpp"
#include "lamina/orientation/no_spin.hpp"
#include "lamina/orientation/orientation_limits.hpp"
#include "lamina/orientation/orientation_smoothing.hpp"
#include "lamina/orientation/path_tangents.hpp"

namespace lamina {
namespace {

constexpr double kSame = 1e-12;       // between components of unit vectors and quaternions
constexpr double kChangedDeg = 1e-6;  // a jet that a limit moved by less was not limited

/// One jet per waypoint, or a single one for all of them.
using Jets = std::vector<Point3>;

bool isWall(PathRole role) { return role == PathRole::OuterWall || role == PathRole::InnerWall; }

Jets givenJets(const Path& run) {
  Jets jets;
  jets.reserve(run.orientation.values().size());
  for (const Eigen::Quaterniond& value : run.orientation.values()) jets.push_back(jetOf(value.normalized()));
  return jets;
}

Point3 fixedJet(const FixedDirection& fixed) {
  const double tilt = fixed.tilt_deg * M_PI / 180.0;
  const double heading = fixed.heading_deg * M_PI / 180.0;
  if (tilt == 0.0) return -Point3::UnitZ();
  return {-std::sin(tilt) * std::cos(heading), -std::sin(tilt) * std::sin(heading), -std::cos(tilt)};
}

Jets leaned(Jets jets, const Path& run, const OrientationSettings& settings) {
  if (settings.lead_deg == 0.0 && settings.tilt_deg == 0.0) return jets;
  const std::vector<Point3> tangents = pathTangents(run);
  if (tangents.empty()) return jets;
  jets.resize(run.points.size(), jets.front());
  for (std::size_t i = 0; i < jets.size(); ++i)
    jets[i] = withLeadAndTilt(jets[i], tangents[i], settings.lead_deg, settings.tilt_deg);
  return jets;
}

/// What a limit wanted and gave at each waypoint, gathered into one entry per run.
class HitCount {
 public:
  explicit HitCount(OrientationLimit limit) { hit_.limit = limit; }

  void add(std::size_t waypoint, double wanted_deg, double given_deg) {
    ++hit_.waypoints;
    if (hit_.waypoints > 1 && wanted_deg - given_deg <= hit_.wanted_deg - hit_.given_deg) return;
    hit_.worst.waypoint = waypoint;
    hit_.wanted_deg = wanted_deg;
    hit_.given_deg = given_deg;
  }
  void appendTo(std::vector<LimitHit>& hits) const {
    if (hit_.waypoints > 0) hits.push_back(hit_);
  }

 private:
  LimitHit hit_;
};

Jets tiltLimited(Jets jets, double max_deg, std::vector<LimitHit>& hits, std::size_t waypoints) {
  HitCount count(OrientationLimit::Tilt);
  const std::size_t each = waypoints / jets.size();  // waypoints per jet: all of them if it is common
  for (std::size_t i = 0; i < jets.size(); ++i) {
    const double wanted = tiltDeg(jets[i]);
    if (wanted <= max_deg + kChangedDeg) continue;
    jets[i] = withTiltLimit(jets[i], max_deg);
    for (std::size_t k = 0; k < each; ++k) count.add(i + k, wanted, max_deg);
  }
  count.appendTo(hits);
  return jets;
}

Jets turnLimited(Jets jets, const Path& run, double max_deg_per_mm, std::vector<LimitHit>& hits) {
  if (max_deg_per_mm == 0.0 || jets.size() < 2) return jets;
  Jets given = withTurnLimit(jets, motionLengths(run), max_deg_per_mm);
  HitCount count(OrientationLimit::Turn);
  for (std::size_t i = 0; i < jets.size(); ++i) {
    if (angleDeg(jets[i], given[i]) <= kChangedDeg) continue;
    const std::size_t before = i > 0 ? i - 1 : run.is_closed ? jets.size() - 1 : 0;
    count.add(i, angleDeg(jets[before], jets[i]), angleDeg(given[before], given[i]));
  }
  count.appendTo(hits);
  return given;
}

AlongPath<Eigen::Quaterniond> heldAlong(const Jets& jets, double heading_deg) {
  if (jets.size() == 1) return noSpinFrame(jets.front(), heading_deg);
  std::vector<Eigen::Quaterniond> frames = noSpinFrames(jets, heading_deg);
  const auto differs = [&](const Eigen::Quaterniond& frame) {
    return (frame.coeffs() - frames.front().coeffs()).cwiseAbs().maxCoeff() > kSame;
  };
  if (std::none_of(frames.begin(), frames.end(), differs)) return frames.front();
  return AlongPath<Eigen::Quaterniond>(std::move(frames));
}

}  // namespace

RunOrientation runOrientation(const Path& run, const OrientationSettings& settings,
                              const WallNormals* walls) {
  RunOrientation result;
  Jets jets;
  if (settings.mode == OrientationMode::Fixed) {
    jets = {fixedJet(settings.fixed)};
  } else if (walls != nullptr && isWall(run.role)) {
    WallJets following = wallFollowingJets(run, *walls);
    jets = std::move(following.jets);
    result.waypoints_without_wall = following.waypoints_without_wall;
  } else {
    jets = givenJets(run);
  }
  jets = leaned(std::move(jets), run, settings);
  jets = smoothedJets(jets, run.is_closed ? Course::Closed : Course::Open, settings.smoothing_window);
  jets = tiltLimited(std::move(jets), settings.limits.max_tilt_deg, result.limits_hit, run.points.size());
  jets = turnLimited(std::move(jets), run, settings.limits.max_turn_deg_per_mm, result.limits_hit);
  result.orientation = heldAlong(jets, settings.heading_deg);
  return result;
}

}  // namespace lamina
