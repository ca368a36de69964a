// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/toolpath_as_run.hpp"

#include <utility>
#include <vector>

namespace lamina {
namespace {

constexpr double kSameTurn = 1e-6;  // rad: under what targets resolve

/// What a closed path has at its first waypoint is that of its return.
template <typename Value>
AlongPath<Value> withReturn(const AlongPath<Value>& along) {
  if (along.isCommon()) return along;
  std::vector<Value> each = along.values();
  each.push_back(each.front());
  return AlongPath<Value>(std::move(each));
}

void open(Path& path) {
  path.is_closed = false;
  path.points.push_back(path.points.front());
  path.bead = withReturn(path.bead);
  path.feed_mm_s = withReturn(path.feed_mm_s);
}

/// Takes the joints of one path after the other.
class Turner {
 public:
  Turner(const KinematicModelRun& run, const KinematicModel& model)
      : part_from_bed_(Eigen::Quaterniond(run.bed_from_part.linear()).conjugate()), model_(model) {}

  void turn(Path& path, JointPath& joints) {
    if (next_ == 0) last_ = path.orientation.at(0);
    std::vector<Eigen::Quaterniond> each;
    for (std::size_t station = 0; station <= path.motionCount(); ++station) each.push_back(nextTurn(joints));
    if (path.is_closed && each.front().angularDistance(each.back()) > kSameTurn) {
      open(path);
      joints.at[next_ - 1].waypoint = path.points.size() - 1;
    }
    if (path.is_closed) each.pop_back();
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  }

 private:
  Eigen::Quaterniond nextTurn(const JointPath& joints) {
    const Eigen::Isometry3d nozzle = model_.bedFromNozzle(joints.values[next_++]);
    Eigen::Quaterniond turn = part_from_bed_ * Eigen::Quaterniond(nozzle.linear());
    if (turn.dot(last_) < 0.0) turn.coeffs() *= -1.0;
    return last_ = turn.normalized();
  }

  Eigen::Quaterniond part_from_bed_;
  const KinematicModel& model_;
  std::size_t next_ = 0;
  Eigen::Quaterniond last_ = Eigen::Quaterniond::Identity();
};

}  // namespace

ToolpathAsRun toolpathAsRun(KinematicModelRun run, const KinematicModel& model) {
  Turner turner(run, model);
  ToolpathAsRun result{std::move(run.divided.toolpath), std::move(run.path)};
  for (ToolpathLayer& layer : result.toolpath.layers)
    for (Path& path : layer.paths) turner.turn(path, result.joints);
  return result;
}

}  // namespace lamina
