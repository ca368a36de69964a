// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/joint_unwinding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lamina {

namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// What the winding joints reach on a stretch.
class Span {
 public:
  explicit Span(const std::vector<JointRange>& ranges) : ranges_(&ranges) { clear(); }

  void clear() {
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
  }

  void add(const JointValues& values) {
    for (std::size_t j = 0; j < ranges_->size(); ++j) {
      const double value = values[static_cast<Eigen::Index>(j)];
      low_[j] = std::min(low_[j], value);
      high_[j] = std::max(high_[j], value);
    }
  }

  double leastTurns(std::size_t j) const {
    return std::ceil(((*ranges_)[j].low - low_[j] - kLimitTolerance) / kTurn);
  }
  double mostTurns(std::size_t j) const {
    return std::floor(((*ranges_)[j].high - high_[j] + kLimitTolerance) / kTurn);
  }

  /// The first joint that no number of whole turns keeps within its limits.
  std::size_t tight() const {
    for (std::size_t j = 0; j < ranges_->size(); ++j)
      if ((*ranges_)[j].winds && leastTurns(j) > mostTurns(j)) return j;
    return kNone;
  }

 private:
  const std::vector<JointRange>* ranges_;
  std::array<double, kMostJoints> low_{};
  std::array<double, kMostJoints> high_{};
};

/// Unwinds one section after another: values that are linked, and nowhere too long to be held.
class Unwinder {
 public:
  Unwinder(std::vector<JointValues> values, const std::vector<WindLink>& links,
           const std::vector<JointRange>& ranges)
      : links_(links), ranges_(ranges), span_(ranges) {
    result_.values = std::move(values);
  }

  Unwound run() {
    const std::size_t count = result_.values.size();
    for (std::size_t begin = 0; begin < count;) {
      if (result_.values[begin].size() == 0) {
        ++begin;
        continue;
      }
      std::size_t end = begin + 1;
      while (end < count && links_[end].is_linked) {
        follow(end);
        ++end;
      }
      turns_.fill(0.0);
      while (begin < end) begin = section(begin, end);
    }
    return std::move(result_);
  }

 private:
  /// The value goes on from the one before the shorter way round.
  void follow(std::size_t i) {
    for (std::size_t j = 0; j < ranges_.size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      const double before = result_.values[i - 1][index];
      double& value = result_.values[i][index];
      value = before + stepBetween(ranges_[j], before, value);
    }
  }

  /// @return where the section ends: at `end`, or where a joint has run out of its limits
  std::size_t section(std::size_t begin, std::size_t end) {
    std::vector<std::size_t> latest;
    const std::size_t reached = latestBreaks(begin, end, latest);
    const std::vector<std::size_t> breaks = bestBreaks(begin, latest, earliestBreaks(begin, reached));
    std::size_t from = begin;
    for (const std::size_t to : breaks) {
      turn(from, to);
      from = to;
      ++result_.rewinds;
    }
    turn(from, reached);
    return reached;
  }

  std::size_t latestBreaks(std::size_t begin, std::size_t end, std::vector<std::size_t>& breaks) {
    span_.clear();
    std::size_t place = kNone;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin && links_[i].may_rewind) place = i;
      span_.add(result_.values[i]);
      const std::size_t tight = span_.tight();
      if (tight == kNone) continue;
      if (place == kNone) {
        result_.wound_up.push_back(woundUp({begin, i, end}, tight));
        return i;
      }
      breaks.push_back(place);
      span_.clear();
      i = place - 1;
      begin = place;
      place = kNone;
    }
    return end;
  }

  struct Stretch {
    std::size_t begin = 0;
    std::size_t out = 0;  ///< where the joint runs out of its limits
    std::size_t end = 0;
  };

  WoundUp woundUp(const Stretch& stretch, std::size_t joint) const {
    const auto index = static_cast<Eigen::Index>(joint);
    const double first = result_.values[stretch.begin][index];
    WoundUp found{stretch.out, joint, first, first};
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
      if (i > stretch.out && links_[i].may_rewind) break;
      found.lowest = std::min(found.lowest, result_.values[i][index]);
      found.highest = std::max(found.highest, result_.values[i][index]);
    }
    const double onto = nearMiddle(ranges_[joint], first) - first;
    found.lowest += onto;
    found.highest += onto;
    return found;
  }

  /// In the order of the motion.
  std::vector<std::size_t> earliestBreaks(std::size_t begin, std::size_t end) {
    std::vector<std::size_t> breaks;
    span_.clear();
    std::size_t place = kNone;
    for (std::size_t i = end; i-- > begin;) {
      span_.add(result_.values[i]);
      if (span_.tight() != kNone) {
        breaks.push_back(place);
        span_.clear();
        i = place;
        place = kNone;
        continue;
      }
      if (i > begin && links_[i].may_rewind) place = i;
    }
    std::reverse(breaks.begin(), breaks.end());
    return breaks;
  }

  /// Between the earliest and the latest place of each break no choice makes later ones impossible. Where the
  /// section ends because a joint runs out, the last of the latest may be for what is beyond.
  std::vector<std::size_t> bestBreaks(std::size_t begin, const std::vector<std::size_t>& latest,
                                      const std::vector<std::size_t>& earliest) {
    std::vector<std::size_t> breaks;
    for (std::size_t k = 0; k < earliest.size(); ++k) {
      span_.clear();
      std::size_t best = kNone;
      for (std::size_t i = begin; i <= latest[k]; ++i) {
        const bool is_place = i > begin && i >= earliest[k] && links_[i].may_rewind;
        if (is_place && (best == kNone || links_[i].rank >= links_[best].rank)) best = i;
        span_.add(result_.values[i]);
        if (span_.tight() != kNone) break;
      }
      breaks.push_back(best);
      begin = best;
    }
    return breaks;
  }

  /// Adds the whole turns nearest to those of the stretch before.
  void turn(std::size_t begin, std::size_t end) {
    span_.clear();
    for (std::size_t i = begin; i < end; ++i) span_.add(result_.values[i]);
    for (std::size_t j = 0; j < ranges_.size(); ++j) {
      if (!ranges_[j].winds) continue;
      turns_[j] = std::clamp(turns_[j], span_.leastTurns(j), span_.mostTurns(j));
      for (std::size_t i = begin; i < end; ++i)
        result_.values[i][static_cast<Eigen::Index>(j)] += kTurn * turns_[j];
    }
  }

  const std::vector<WindLink>& links_;
  const std::vector<JointRange>& ranges_;
  Span span_;
  std::array<double, kMostJoints> turns_{};
  Unwound result_;
};

}  // namespace

Unwound unwind(std::vector<JointValues> values, const std::vector<WindLink>& links,
               const std::vector<JointRange>& ranges) {
  return Unwinder(std::move(values), links, ranges).run();
}

}  // namespace lamina
