// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "kinematics/joint_path/ladder_search.hpp"
#include "kinematics/joint_path/station_joints.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {

namespace {

constexpr std::size_t kBlock = 64;                  // rungs held at a time, twice
constexpr double kSteadyToolAxis = toRadians(0.1);  // far below what a head is held to
const std::string kStage = "joints";

/// Of loops within a stage: they can be cancelled, and report nothing.
class CancelOnly final : public Progress {
 public:
  explicit CancelOnly(const Progress& whole) : whole_(&whole) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return whole_->isCancelled(); }

 private:
  const Progress* whole_;
};

/// Whether half of the steps of the joints turn the nozzle half of the way.
class HalfWayTest {
 public:
  HalfWayTest(const KinematicModel& model, const std::vector<JointRange>& ranges)
      : model_(&model), ranges_(&ranges) {}

  bool operator()(const double* from, const double* to) const {
    const auto count = static_cast<Eigen::Index>(ranges_->size());
    const JointValues start = Eigen::Map<const Eigen::VectorXd>(from, count);
    const JointValues end = Eigen::Map<const Eigen::VectorXd>(to, count);
    JointValues half = start;
    for (std::size_t j = 0; j < ranges_->size(); ++j)
      half[static_cast<Eigen::Index>(j)] += 0.5 * stepBetween((*ranges_)[j], from[j], to[j]);
    const Eigen::Quaterniond a(model_->bedFromNozzle(start).linear());
    const Eigen::Quaterniond b(model_->bedFromNozzle(end).linear());
    const Eigen::Quaterniond between(model_->bedFromNozzle(half).linear());
    if (model_->toolAxisSpin() == ToolAxisSpin::Given)
      return a.slerp(0.5, b).angularDistance(between) <= kSteadyToolAxis;
    const Point3 tool_axis = between * Point3::UnitZ();
    const Point3 mean = a * Point3::UnitZ() + b * Point3::UnitZ();
    return std::atan2(mean.cross(tool_axis).norm(), mean.dot(tool_axis)) <= kSteadyToolAxis;
  }

 private:
  const KinematicModel* model_;
  const std::vector<JointRange>* ranges_;
};

StationFault jump(const StationTask& task, std::size_t station, const LadderSearch::Cut& cut) {
  if (!std::isfinite(cut.turn))
    return {station, JointFault::Jump, "no solution here is of a branch that the waypoint before has"};
  const std::string joint = "joint " + task.model.joints()[cut.joint].name;
  const std::string turn = jointValueText(task.solver.ranges()[cut.joint], std::abs(cut.turn));
  if (cut.is_wound)
    return {station, JointFault::JointUnwinding,
            joint + " is at its limit and would have to be wound back by " + turn + " while depositing"};
  const std::string length = lengthText(task.stations[station].motion.length_mm);
  const std::string most = angleText(toRadians(task.settings.max_turn_deg));
  return {station, JointFault::Jump,
          joint + " would have to turn by " + turn + " within " + length + "; at most " + most};
}

/// The search, a block of rungs at a time.
class BlockSearch {
 public:
  BlockSearch(const StationTask& task, RungStore& rungs, StationWayThrough& way, const Progress& progress)
      : task_(task),
        rungs_(rungs),
        way_(way),
        progress_(progress),
        search_(task.solver.ranges(), task.settings, HalfWayTest(task.model, task.solver.ranges())) {}

  /// Solves the rungs from a station on while those solved before are searched.
  void step(std::size_t first) {
    inParallel([&] { solveFrom(first); }, [&] { searchReady(); });
    keepSolved(first);
    std::swap(ready_, coming_);
  }

  std::vector<NodeId> trace() const { return search_.trace(); }

 private:
  void solveFrom(std::size_t first) {
    const std::size_t count = task_.stations.size();
    coming_.resize(std::min(kBlock, count - std::min(first, count)));
    solved_.assign(coming_.size(), std::nullopt);
    // A block of an arm that is solved by iteration takes minutes.
    CancelOnly silent(progress_);
    parallelFor(
        coming_.size(), [&](std::size_t i) { solve(task_.stations[first + i], i); }, silent, kStage);
  }

  void solve(const Station& station, std::size_t i) {
    if (std::optional<Rung> kept = rungs_.find(station)) {
      coming_[i] = *std::move(kept);
      return;
    }
    coming_[i] = task_.solver.solve(station);
    // What a free joint of a machine is tried at is solved in less time than it takes room.
    if (coming_[i].kind == SampleKind::Yaw && !rungs_.isFull()) solved_[i].emplace(coming_[i]);
  }

  void keepSolved(std::size_t first) {
    for (std::size_t i = 0; i < solved_.size(); ++i)
      if (solved_[i]) rungs_.add(task_.stations[first + i], *std::move(solved_[i]));
  }

  void searchReady() {
    for (Rung& rung : ready_) {
      const std::size_t station = searched_++;
      way_.stations[station].kind = rung.kind;
      const auto link = search_.advance(std::move(rung), task_.stations[station].motion);
      way_.stations[station].is_linked = link == LadderSearch::Link::Joined;
      if (link == LadderSearch::Link::Cut) way_.faults.push_back(jump(task_, station, search_.lastCut()));
      if (link != LadderSearch::Link::Empty) continue;
      const RungSolver::Hindrance hindrance = task_.solver.hindrance(task_.stations[station]);
      way_.faults.push_back({station, hindrance.fault, hindrance.reason});
    }
  }

  const StationTask& task_;
  RungStore& rungs_;
  StationWayThrough& way_;
  const Progress& progress_;
  LadderSearch search_;
  std::size_t searched_ = 0;
  std::vector<Rung> ready_;
  std::vector<Rung> coming_;
  std::vector<std::optional<KeptRung>> solved_;  ///< those of them that are to be kept
};

}  // namespace

StationWayThrough searchLadder(const StationTask& task, RungStore& rungs, Progress& progress) {
  const std::size_t count = task.stations.size();
  StationWayThrough way;
  way.stations.resize(count);
  BlockSearch search(task, rungs, way, progress);
  for (std::size_t first = 0; first < count + kBlock; first += kBlock) {
    throwIfCancelled(progress, kStage);
    search.step(first);
    progress.report(kStage, std::min(1.0, static_cast<double>(first) / static_cast<double>(count)));
  }
  const std::vector<NodeId> nodes = search.trace();
  CancelOnly silent(progress);
  parallelFor(
      count,
      [&](std::size_t i) {
        StationJoints& here = way.stations[i];
        here.node = nodes[i];
        if (nodes[i] == kNoNode) return;
        const double coordinate = task.solver.coordinateOf(here.kind, nodes[i]);
        here.values = *task.solver.at(task.stations[i], here.kind, coordinate, branchOf(nodes[i]));
      },
      silent, kStage);
  return way;
}

}  // namespace lamina
