// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "kinematics/arm/arm_axes.hpp"
#include "kinematics/arm/newton_refinement.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kMostWristGap = 0.5;  // mm: between axes 4 and 5
constexpr double kShortestLink = 1.0;  // mm: of an arm that is one
constexpr int kSamples = 180;          // of axis 6: some find all roots but double ones, which are looked for
constexpr int kPolish = 6;             // steps to where Newton's method on all joints goes on
constexpr double kNearRoot = 1e-7;     // of the cosine
constexpr double kNearTouch = 0.05;    // the same: a minimum that low may hide two roots
constexpr double kTouch = 1e-3;        // the same, once a minimum has been looked at closely
constexpr int kTouchSteps = 2;
constexpr int kEndSteps = 12;           // to where the reach ends
constexpr std::size_t kEndSamples = 6;  // before it
constexpr double kNearReach = 0.05;     // of a cosine over 1: beyond it there is nothing to look for
constexpr double kSameRoot = 1e-6;      // rad
constexpr double kLevel = 1e-9;         // of sines: below it they are no divisor
constexpr std::size_t kWays = 4;        // of axes 1 to 3

/// An arm whose axes 4 and 5 meet, whose axis 2 is at a right angle to 1, and 3 a parallel of 2. Vectors of
/// the frame of axis 1 have their last coordinate along that axis, and the second at a right angle to axis 2.
struct OffsetWristArm {
  explicit OffsetWristArm(const ArmAxes& at_zero)
      : axes(at_zero), wrist(nearest(axes[4], axes[3])), plane(axes, wrist) {
    const Point3& first = plane.first();
    const Point3& second = plane.normal();
    const Point3& fourth = axes[3].direction;
    cosine = fourth.dot(axes[4].direction);
    frame.row(2) = first;
    frame.row(1) = first.cross(second).normalized();
    frame.row(0) = frame.row(1).cross(frame.row(2));
    normal = frame * second;
    height = second.dot(wrist - plane.centre());
    const double along = second.dot(fourth);
    fourth_even = frame * (along * second);
    fourth_across = frame * (fourth - along * second);
    fourth_aside = frame * second.cross(fourth);
    for (int axis = 0; axis < 3; ++axis) in_plane.col(axis) = plane.inPlane(frame.row(axis).transpose());
    shoulder = plane.inPlane(plane.shoulder() - plane.centre());
  }

  ArmAxes axes;
  Point3 wrist;  ///< where axes 4 and 5 meet
  ArmPlane plane;
  double cosine = 0.0;    ///< of axis 5 to axis 4
  Eigen::Matrix3d frame;  ///< of axis 1, from the bed
  Point3 normal;          ///< axis 2 in that frame, as are those below
  double height = 0.0;    ///< of the wrist along axis 2, over axis 1 [mm]
  /// Axis 4 as axes 2 and 3 turn it: even + cos · across + sin · aside.
  Point3 fourth_even;
  Point3 fourth_across;
  Point3 fourth_aside;
  Eigen::Matrix<double, 2, 3> in_plane;  ///< coordinates in the plane of the arm, from the frame
  Point2 shoulder;                       ///< axis 2 in that plane [mm]
};

/// A vector that axis 6 turns back: even + cos · across + sin · aside.
struct TurnedBySixth {
  TurnedBySixth(const Point3& vector, const Point3& sixth, const Eigen::Matrix3d& moved) {
    const Point3 along = sixth.dot(vector) * sixth;
    even = moved * along;
    across = moved * (vector - along);
    aside = moved * vector.cross(sixth);
  }
  Point3 at(const Turn& turn) const { return even + turn.x() * across + turn.y() * aside; }

  Point3 even;
  Point3 across;
  Point3 aside;
};

const std::array<Turn, kSamples>& sampledTurns() {
  static const std::array<Turn, kSamples> turns = [] {
    std::array<Turn, kSamples> all;
    for (int i = 0; i < kSamples; ++i) all[static_cast<std::size_t>(i)] = turnOf(2.0 * M_PI * i / kSamples);
    return all;
  }();
  return turns;
}

/// Finds the solutions of one pose: for a value of axis 6 the place of the wrist is known, and axes 1 to 3
/// follow in four ways. The value is right if axis 5 then stands to axis 4 as it does in the arm.
class OffsetWristSolver {
 public:
  OffsetWristSolver(const OffsetWristArm& arm, const Eigen::Isometry3d& moved)
      : arm_(arm),
        wrist_(arm.wrist - arm.axes[5].point, arm.axes[5].direction, moved.linear()),
        framed_wrist_(arm.wrist - arm.axes[5].point, arm.axes[5].direction, arm.frame * moved.linear()),
        framed_fifth_(arm.axes[4].direction, arm.axes[5].direction, arm.frame * moved.linear()),
        on_sixth_(moved * arm.axes[5].point),
        moved_(moved) {
    framed_wrist_.even += arm.frame * (on_sixth_ - arm.plane.centre());
  }

  /// Values near solutions, for Newton's method.
  std::vector<ArmValues> all() const {
    std::array<Residuals, kSamples> sampled;
    for (std::size_t i = 0; i < kSamples; ++i) sampled[i] = residuals(sampledTurns()[i]);
    std::vector<ArmValues> found;
    for (std::size_t way = 0; way < kWays; ++way)
      for (std::size_t i = 0; i < kSamples; ++i) {
        const double angle = kStep * static_cast<double>(i);
        const auto sample = [&](std::size_t at, double place) {
          const Residuals& there = sampled[at % kSamples];
          return Sample{place, there.f[way], there.excess[way]};
        };
        for (const double root :
             rootsNear(way, {sample(i + kSamples - 1, angle - kStep), sample(i, angle),
                             sample(i + 1, angle + kStep), sample(i + 2, angle + 2.0 * kStep)}))
          found.push_back(valuesAt(way, root));
      }
    return found;
  }

 private:
  static constexpr double kStep = 2.0 * M_PI / kSamples;

  struct Sample {
    double angle;
    double f;
    double excess;  ///< positive out of reach

    bool isReached() const { return excess <= 0.0; }
    bool isNegative() const { return f < 0.0; }
  };

  struct Residuals {
    std::array<double, kWays> f{};
    std::array<double, kWays> excess{};
  };

  using Places = boost::container::static_vector<double, 2>;
  using Roots = boost::container::static_vector<double, 8>;

  /// What is sampled of one way: angles of axis 6, or the root of their distance from where the reach ends.
  struct Line {
    std::size_t way;
    double end;
    double sense;
    bool is_root;

    double angleAt(double place) const { return is_root ? end + sense * place * place : place; }
    Sample at(const OffsetWristSolver& solver, double place) const {
      const Sample there = solver.sampleAt(way, angleAt(place));
      return {place, there.f, there.excess};
    }
  };

  /// Between the second and the third of four samples, or where the residual nearly touches zero at the
  /// second. Some may be beyond reach: Newton's method distinguishes them.
  Roots rootsNear(std::size_t way, const std::array<Sample, 4>& at) const {
    const auto& [before, here, next, after] = at;
    if (here.excess > kNearReach && next.excess > kNearReach) return {};
    if (here.isReached() && !next.isReached()) return rootsToEnd(way, before, here, next);
    if (next.isReached() && !here.isReached()) return rootsToEnd(way, after, next, here);
    Roots roots;
    addRoots({way, 0.0, 1.0, false}, {before, here, next}, roots);
    return roots;
  }

  /// Between the end of the reach and the second sample within it, if there are two. The residual rises or
  /// falls there as the root of the way from the end, and may turn back within less than a sample: it is
  /// sampled over that root.
  Roots rootsToEnd(std::size_t way, const Sample& inner, const Sample& within, const Sample& beyond) const {
    const Sample end = reachEnd(way, within, beyond);
    const Line line{way, end.angle, within.angle < end.angle ? -1.0 : 1.0, true};
    const double last = std::sqrt(std::abs(end.angle - (inner.isReached() ? inner : within).angle));
    std::array<Sample, kEndSamples + 2> at;
    at[0] = Sample{0.0, end.f, end.excess};
    for (std::size_t i = 1; i < at.size(); ++i)
      at[i] = line.at(*this, last * static_cast<double>(i) / kEndSamples);
    Roots roots;
    addRoots(line, {at[1], at[0], at[1]}, roots);
    for (std::size_t i = 1; i <= kEndSamples; ++i) addRoots(line, {at[i - 1], at[i], at[i + 1]}, roots);
    return roots;
  }

  /// Roots from the second to the third of three samples of a line, or about the second, as angles.
  void addRoots(const Line& line, const std::array<Sample, 3>& at, Roots& roots) const {
    const auto& [before, here, next] = at;
    const auto add = [&](double place) {
      if (roots.size() < roots.capacity()) roots.push_back(line.angleAt(place));
    };
    if (here.isNegative() != next.isNegative()) return add(rootIn(line, here, next));
    const double least = std::abs(here.f);
    const bool is_least = least <= kNearTouch && least <= std::abs(next.f) && least <= std::abs(before.f);
    if (!is_least || before.isNegative() != here.isNegative()) return;
    for (const double place : touchingRoots(line, before, here, next)) add(place);
  }

  /// The last place within reach between one within and one beyond.
  Sample reachEnd(std::size_t way, Sample within, Sample beyond) const {
    for (int step = 0; step < kEndSteps; ++step) {
      const double span = beyond.angle - within.angle;
      const double share = within.excess / (within.excess - beyond.excess);
      const double at = within.angle + span * std::clamp(share, 0.02, 0.98);
      const Sample middle = sampleAt(way, at);
      (middle.isReached() ? within : beyond) = middle;
    }
    return within;
  }

  /// For each of the ways of axes 1 to 3; those out of reach by the one that comes nearest, so that the
  /// residual goes on steadily.
  Residuals residuals(const Turn& sixth) const {
    const Point3 wrist = framed_wrist_.at(sixth);
    const Point3 fifth = framed_fifth_.at(sixth);
    const Point3& normal = arm_.normal;
    const TwoTurns firsts =
        turnsWith(wrist.x() * normal.x() + wrist.z() * normal.z(), wrist.y() * normal.x(), arm_.height);
    Residuals residuals;
    for (std::size_t i = 0; i < 2; ++i) {
      const Turn& first = firsts.turns[i];
      const Point3 seen = withoutFirst(fifth, first);
      const double even = seen.dot(arm_.fourth_even) - arm_.cosine;
      const double across = seen.dot(arm_.fourth_across);
      const double aside = seen.dot(arm_.fourth_aside);
      const auto bends = arm_.plane.bendsTo(arm_.in_plane * withoutFirst(wrist, first) - arm_.shoulder);
      for (std::size_t k = 0; k < 2; ++k) {
        const Turn& both = bends.both[k];
        residuals.excess[2 * i + k] = std::max(firsts.excess, bends.excess);
        residuals.f[2 * i + k] = even + both.x() * across + both.y() * aside;
      }
    }
    return residuals;
  }

  /// A vector of the frame of axis 1 with the rotation of that axis taken back.
  static Point3 withoutFirst(const Point3& vector, const Turn& first) {
    return {first.x() * vector.x() + first.y() * vector.y(), first.x() * vector.y() - first.y() * vector.x(),
            vector.z()};
  }

  Sample sampleAt(std::size_t way, double angle) const {
    const Residuals there = residuals(turnOf(angle));
    return {angle, there.f[way], there.excess[way]};
  }

  /// Between values of different signs, by the false position with halved weights.
  double rootIn(const Line& line, Sample low, Sample high) const {
    double at = low.angle;
    for (int step = 0; step < kPolish; ++step) {
      at = low.angle - low.f * (high.angle - low.angle) / (high.f - low.f);
      const Sample middle = line.at(*this, at);
      if (std::abs(middle.f) < kNearRoot) break;
      if ((middle.f < 0.0) == (high.f < 0.0)) {
        high = middle;
        low.f *= 0.5;
      } else {
        low = high;
        high = middle;
      }
    }
    return at;
  }

  /// Two roots between samples of one sign, or the place where the residual is least.
  Places touchingRoots(const Line& line, Sample before, Sample here, Sample next) const {
    for (int step = 0; step < kPolish; ++step) {
      const double bend = next.f - 2.0 * here.f + before.f;
      const double width = 0.5 * (next.angle - before.angle);
      const double shift = bend != 0.0 ? -0.5 * width * (next.f - before.f) / bend : 0.0;
      const Sample least = line.at(*this, here.angle + std::clamp(shift, -0.5 * width, 0.5 * width));
      if (least.isNegative() != here.isNegative())
        return {rootIn(line, before, least), rootIn(line, least, next)};
      if (std::abs(least.f) < std::abs(here.f)) here = least;
      const Sample left = line.at(*this, here.angle - 0.4 * width);
      const Sample right = line.at(*this, here.angle + 0.4 * width);
      if (left.isNegative() != here.isNegative())
        return {rootIn(line, before, left), rootIn(line, left, here)};
      if (right.isNegative() != here.isNegative())
        return {rootIn(line, here, right), rootIn(line, right, next)};
      before = left;
      next = right;
      if (step >= kTouchSteps && std::abs(here.f) > kTouch) return {};
    }
    return {here.angle};
  }

  ArmValues valuesAt(std::size_t way, double angle) const {
    const Turn sixth = turnOf(angle);
    const Point3 wrist = on_sixth_ + wrist_.at(sixth);
    const Turn first = arm_.plane.firstTurns(wrist, arm_.wrist).turns[way / 2];
    const auto inner = arm_.plane.waysTo(arm_.plane.turnedBack(wrist, first)).ways[way % 2];
    const Turn both = sum(inner.second, inner.third);
    const auto outwards = [&](const Point3& direction) {
      const Point3 moved =
          moved_.linear() * turned(direction, arm_.axes[5].direction, {sixth.x(), -sixth.y()});
      return turned(turned(moved, arm_.plane.first(), {first.x(), -first.y()}), arm_.plane.normal(),
                    {both.x(), -both.y()});
    };
    const Point3& fourth = arm_.axes[3].direction;
    const Point3& fifth = arm_.axes[4].direction;
    const Turn fourth_turn = turnBetween(fifth, outwards(fifth), fourth).normalized();
    const Point3 mark = turned(outwards(fourth), fourth, {fourth_turn.x(), -fourth_turn.y()});
    ArmValues values;
    values << angleOf(first), arm_.plane.secondValue(inner), arm_.plane.thirdValue(inner),
        angleOf(fourth_turn), angleOf(turnBetween(fourth, mark, fifth)), angle;
    return values;
  }

  const OffsetWristArm& arm_;
  TurnedBySixth wrist_;
  TurnedBySixth framed_wrist_;  ///< from axis 1, in its frame, as is the one below
  TurnedBySixth framed_fifth_;
  Point3 on_sixth_;
  const Eigen::Isometry3d& moved_;
};

/// Of values in (-pi, pi].
bool isSameRoot(const ArmValues& one, const ArmValues& other) {
  for (Eigen::Index j = 0; j < one.size(); ++j) {
    const double off = std::abs(one[j] - other[j]);
    if (std::min(off, 2.0 * M_PI - off) >= kSameRoot) return false;
  }
  return true;
}

class OffsetWristInverse : public ArmInverse {
 public:
  explicit OffsetWristInverse(const SerialChain& arm)
      : arm_(arm),
        geometry_(axesAtZero(arm)),
        nozzle_from_bed_at_zero_(arm.bed_from_nozzle_at_zero.inverse()) {}

  ArmSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle, const ArmValues&) const override {
    const Eigen::Isometry3d moved = bed_from_nozzle * nozzle_from_bed_at_zero_;
    ArmSolutions found;
    for (const ArmValues& start : OffsetWristSolver(geometry_, moved).all()) {
      const auto values = lamina::refined(arm_, bed_from_nozzle, start);
      const auto isSame = [&](const ArmSolution& known) { return isSameRoot(known.values, *values); };
      if (values && found.size() < found.capacity() && std::none_of(found.begin(), found.end(), isSame))
        found.push_back({branchOf(sines(*values)), *values});
    }
    return numbered(found);
  }

  /// That of the wrist is of axis 6 against what axes 4 and 5 leave free while the wrist stays.
  ArmSines sines(const ArmValues& values) const override {
    const ArmAxes axes = axesAt(arm_, values);
    const Point3 wrist = nearest(axes[4], axes[3]);
    ArmSines sines = generalSines(axes);
    sines.shoulder = shoulderSine(axes, wrist);
    Eigen::Matrix3d carry;
    Eigen::Matrix3d turns;
    for (int j = 0; j < 3; ++j) {
      const Screw& axis = axes[static_cast<std::size_t>(j)];
      turns.col(j) = axis.direction;
      carry.col(j) = axis.direction.cross(wrist - axis.point);
    }
    const double size = geometry_.plane.upper() * geometry_.plane.fore() *
                        (axes[0].direction.cross(wrist - axes[0].point).norm() + kShortestLink);
    if (std::abs(carry.determinant()) < kLevel * size) return sines;
    const Point3 swung = axes[5].direction.cross(wrist - axes[5].point);
    const Point3 left = axes[5].direction - turns * carry.partialPivLu().solve(swung);
    const double triple = axes[3].direction.cross(left).dot(axes[4].direction);
    sines.wrist = triple / std::max(1.0, left.norm());
    return sines;
  }

  double singularityMargin(const ArmValues& values) const override {
    const ArmSines at = sines(values);
    return std::min({std::abs(at.shoulder), std::abs(at.elbow), std::abs(at.wrist)});
  }

 private:
  /// Solutions of the same signs by their joint 6: the first keeps its branch, others have 8, 16, ... more.
  static ArmSolutions numbered(ArmSolutions found) {
    std::sort(found.begin(), found.end(), [](const ArmSolution& a, const ArmSolution& b) {
      return a.branch != b.branch ? a.branch < b.branch : a.values[5] < b.values[5];
    });
    for (std::size_t i = found.size(); i-- > 0;) {
      int before = 0;
      for (std::size_t k = 0; k < i; ++k) before += found[k].branch == found[i].branch ? 1 : 0;
      found[i].branch += 8 * before;
    }
    std::sort(found.begin(), found.end(),
              [](const ArmSolution& a, const ArmSolution& b) { return a.branch < b.branch; });
    return found;
  }

  SerialChain arm_;
  OffsetWristArm geometry_;
  Eigen::Isometry3d nozzle_from_bed_at_zero_;
};

}  // namespace

std::unique_ptr<const ArmInverse> offsetWristInverse(const SerialChain& arm) {
  const ArmAxes axes = axesAtZero(arm);
  if (!areAtRightAngle(axes[0], axes[1]) || !areParallel(axes[1], axes[2]) || areParallel(axes[3], axes[4]) ||
      areParallel(axes[4], axes[5]) || gapBetween(axes[3], axes[4]) > kMostWristGap)
    return nullptr;
  const OffsetWristArm geometry(axes);
  if (geometry.plane.upper() < kShortestLink || geometry.plane.fore() < kShortestLink) return nullptr;
  return std::make_unique<OffsetWristInverse>(arm);
}

}  // namespace lamina
