// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/redundancy_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "kinematics/joint_path/evened_angles.hpp"
#include "kinematics/joint_path/ladder_search.hpp"
#include "kinematics/joint_path/rung_solver.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {

namespace {

constexpr double kLandmarkSpacing = 10.0;       // mm: an arm hardly moves over it
constexpr double kLandmarkTurn = 0.2;           // rad of the nozzle: the same
constexpr std::size_t kMostNodes = 64'000'000;  // 128 MB
constexpr int kFewestYaws = 8;
constexpr std::size_t kLandmarkBlock = 32;  // rungs held at a time

/// A station of the coarse ladder.
struct Landmark {
  std::size_t station = 0;
  StationMotion motion;  ///< from the landmark before
  double angle = 0.0;    ///< chosen [rad]
  bool is_known = false;
  bool goes_on = false;  ///< whether the angle goes on from the one before without a leap
};

bool endsMotions(const std::vector<Station>& stations, std::size_t i) {
  if (i == 0 || i + 1 == stations.size()) return true;
  const StationWay here = stations[i].motion.way;
  const StationWay next = stations[i + 1].motion.way;
  return here != next || here == StationWay::ClearTravel;
}

std::vector<Landmark> landmarksOf(const std::vector<Station>& stations) {
  std::vector<Landmark> landmarks;
  StationMotion motion;
  motion.duration_s = 0.0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (i > 0) {
      motion.length_mm += stations[i].motion.length_mm;
      motion.duration_s += stations[i].motion.duration_s;
      motion.lift_mm = stations[i].motion.lift_mm;
      motion.way = stations[i].motion.way;
    }
    const bool is_far = i > 0 && (motion.length_mm >= kLandmarkSpacing ||
                                  stations[landmarks.back().station].orientation.angularDistance(
                                      stations[i].orientation) >= kLandmarkTurn);
    if (!is_far && !endsMotions(stations, i)) continue;
    Landmark landmark;
    landmark.station = i;
    landmark.motion = motion;
    landmark.motion.duration_s = std::max(motion.duration_s, kLeastDuration);
    landmarks.push_back(landmark);
    motion = StationMotion();
    motion.duration_s = 0.0;
  }
  return landmarks;
}

/// Rungs for one value of the redundancy each, as the rows of one rung. A row at a singularity, which has
/// samples of a free joint instead of the one pose, has no nodes.
Rung inRows(const std::vector<Rung>& rows) {
  Rung rung;
  rung.kind = rows.front().kind == SampleKind::Yaw ? SampleKind::Yaw : SampleKind::Single;
  rung.rows = static_cast<int>(rows.size());
  rung.joints = rows.front().joints;
  const int per_row = rung.kind == SampleKind::Yaw ? rows.front().samples : 1;
  rung.samples = rung.rows * per_row;
  for (const Rung& row : rows) rung.branches = std::max(rung.branches, row.branches);
  const auto joints = static_cast<std::size_t>(rung.joints);
  const std::size_t nodes = rung.slot(rung.samples, 0);
  rung.values.resize(nodes * joints);
  rung.penalty.assign(nodes, std::numeric_limits<double>::infinity());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Rung& row = rows[r];
    if (row.kind != rung.kind) continue;
    for (std::size_t from = 0; from < row.penalty.size(); ++from) {
      const NodeId node = row.idOf(from);
      const std::size_t to = rung.slot(static_cast<int>(r) * per_row + sampleOf(node), branchOf(node));
      rung.penalty[to] = row.penalty[from];
      std::copy_n(row.at(from), joints, rung.values.begin() + static_cast<std::ptrdiff_t>(to * joints));
    }
  }
  return rung;
}

/// As many yaws as a node's number and the memory allow.
JointPathSettings coarseSettings(JointPathSettings settings, std::size_t landmarks) {
  const auto rows = static_cast<std::size_t>(settings.redundancy_samples);
  const std::size_t affordable = kMostNodes / (landmarks * rows * static_cast<std::size_t>(kUsualBranches));
  const int most = (kMostSamples - 1) / settings.redundancy_samples;
  const int yaws = std::clamp(static_cast<int>(std::min<std::size_t>(affordable, kMostSamples)),
                              std::min(kFewestYaws, most), most);
  settings.yaw_samples = std::min(settings.yaw_samples, yaws);
  return settings;
}

/// The ladder over landmarks.
class RedundancyLadder {
 public:
  RedundancyLadder(const std::vector<Station>& stations, std::vector<Landmark> landmarks,
                   const GuardedModel& guarded, const JointPathSettings& settings)
      : stations_(stations),
        landmarks_(std::move(landmarks)),
        rows_(settings.redundancy_samples),
        solver_(guarded, settings),
        search_(solver_.ranges(), settings, nullptr) {}

  std::vector<Landmark> run(const Progress& progress) && {
    per_row_.reserve(landmarks_.size());
    for (std::size_t first = 0; first < landmarks_.size(); first += kLandmarkBlock) {
      throwIfCancelled(progress, "joints");
      searchBlock(first);
    }
    const std::vector<NodeId> nodes = search_.trace();
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      landmarks_[i].is_known = nodes[i] != kNoNode;
      if (landmarks_[i].is_known) landmarks_[i].angle = angleOfRow(sampleOf(nodes[i]) / per_row_[i]);
    }
    return std::move(landmarks_);
  }

 private:
  double angleOfRow(int row) const { return 2.0 * M_PI * row / rows_; }

  void searchBlock(std::size_t first) {
    std::vector<Rung> block(std::min(kLandmarkBlock, landmarks_.size() - first));
    parallelFor(block.size(), [&](std::size_t i) { block[i] = solved(landmarks_[first + i]); });
    for (std::size_t i = 0; i < block.size(); ++i) {
      Landmark& landmark = landmarks_[first + i];
      per_row_.push_back(block[i].samples / block[i].rows);
      const auto link = search_.advance(std::move(block[i]), landmark.motion);
      landmark.goes_on = link == LadderSearch::Link::Joined && landmark.motion.way != StationWay::ClearTravel;
    }
  }

  Rung solved(const Landmark& landmark) const {
    Station station = stations_[landmark.station];
    std::vector<Rung> rows;
    rows.reserve(static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row) {
      station.redundancy = angleOfRow(row);
      rows.push_back(solver_.solve(station));
    }
    return inRows(rows);
  }

  const std::vector<Station>& stations_;
  std::vector<Landmark> landmarks_;
  int rows_;
  RungSolver solver_;
  LadderSearch search_;
  std::vector<int> per_row_;  ///< samples, of each landmark
};

/// Angles for landmarks that have none, and none that differ by whole turns from what is before.
void continueAngles(std::vector<Landmark>& landmarks) {
  const auto first =
      std::find_if(landmarks.begin(), landmarks.end(), [](const Landmark& each) { return each.is_known; });
  double angle = first == landmarks.end() ? 0.0 : std::remainder(first->angle, 2.0 * M_PI);
  for (Landmark& landmark : landmarks) {
    if (landmark.is_known) angle += std::remainder(landmark.angle - angle, 2.0 * M_PI);
    landmark.angle = angle;
  }
}

void evenOut(std::vector<Landmark>& landmarks, double most_deviation) {
  for (std::size_t begin = 0; begin < landmarks.size();) {
    std::size_t end = begin + 1;
    while (end < landmarks.size() && landmarks[end].goes_on) ++end;
    std::vector<double> angles;
    angles.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) angles.push_back(landmarks[i].angle);
    const std::vector<double> even = evenedOut(angles, most_deviation);
    for (std::size_t i = begin; i < end; ++i) landmarks[i].angle = even[i - begin];
    begin = end;
  }
}

/// Angles of the stations from one landmark to the next.
void leadAngles(std::vector<Station>& stations, const Landmark& from, const Landmark& to) {
  double passed_s = 0.0;
  for (std::size_t i = from.station + 1; i <= to.station; ++i) {
    passed_s += stations[i].motion.duration_s;
    const double part = std::min(1.0, passed_s / to.motion.duration_s);
    stations[i].redundancy = from.angle + part * (to.angle - from.angle);
  }
}

}  // namespace

void resolveRedundancy(std::vector<Station>& stations, const GuardedModel& guarded,
                       const JointPathSettings& settings, Progress& progress) {
  if (guarded.model.redundancy() == nullptr || stations.empty() || settings.redundancy_samples == 1) return;
  std::vector<Landmark> landmarks = landmarksOf(stations);
  const JointPathSettings coarse = coarseSettings(settings, landmarks.size());
  landmarks = RedundancyLadder(stations, std::move(landmarks), guarded, coarse).run(progress);
  continueAngles(landmarks);
  evenOut(landmarks, M_PI / settings.redundancy_samples);
  stations.front().redundancy = landmarks.front().angle;
  for (std::size_t i = 1; i < landmarks.size(); ++i) leadAngles(stations, landmarks[i - 1], landmarks[i]);
}

}  // namespace lamina
