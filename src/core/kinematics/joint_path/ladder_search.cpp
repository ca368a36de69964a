// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/ladder_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lamina/base/angle.hpp"

namespace lamina {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStandingStill =
    100.0;  // times as dear, where a free joint may turn before or after instead
/// Times as dear to turn a joint on the way into a singularity or out of it: however finely this way is
/// divided, the joint would turn on its one end, and lead the tip off it. Within, waypoints leave it free.
constexpr double kIntoSingularity = 20.0;
constexpr int kRowReach = 1;                    // rows from a rung to the next: the redundancy turns slowly
constexpr std::size_t kMostTravelEdges = 4096;  // some 50 µs: little beside solving both rungs

bool exists(const Rung& rung, std::size_t slot) { return rung.penalty[slot] < kNever; }

bool hasNodes(const Rung& rung) {
  return std::any_of(rung.penalty.begin(), rung.penalty.end(), [](double p) { return p < kNever; });
}

/// Whether both are samples of the same things all around, so that neighbours have neighbouring numbers.
bool areAlike(const Rung& a, const Rung& b) {
  const bool is_sampled = a.kind != SampleKind::Single || a.rows > 1;
  return is_sampled && a.kind == b.kind && a.samples == b.samples && a.rows == b.rows;
}

int samplesPerRow(const Rung& rung) { return rung.samples / rung.rows; }

/// Numbers around a turn, from the first on.
struct Window {
  int first = 0;
  int count = 0;
};

/// Those at most `reach` from a number, or all of them.
Window windowAbout(int number, int around, int reach) {
  if (2 * reach + 1 >= around) return {0, around};
  return {number - reach + around, 2 * reach + 1};
}

}  // namespace

LadderSearch::LadderSearch(std::vector<JointRange> ranges, const JointPathSettings& settings,
                           SteadyCrossing crossing)
    : ranges_(std::move(ranges)), settings_(settings), crossing_(std::move(crossing)) {
  for (const JointRange& range : ranges_) {
    weights_.push_back(1.0 / (range.max_speed * range.max_speed));
    half_periods_.push_back(range.winds ? M_PI : kNever);
    most_turn_.push_back(range.is_rotary ? toRadians(settings_.max_turn_deg) : kNever);
  }
}

/// Squared steps of the joints over their speeds; infinite if one of them is more than the factor times the
/// greatest turn.
double LadderSearch::edge(const double* from, const double* to, double most_turn_factor) const {
  double sum = 0.0;
  bool is_short = true;
  for (std::size_t j = 0; j < weights_.size(); ++j) {
    const double plain = std::abs(to[j] - from[j]);
    const double step = plain > half_periods_[j] ? plain - 2.0 * half_periods_[j] : plain;
    is_short &= std::abs(step) <= most_turn_[j] * most_turn_factor;
    sum += weights_[j] * step * step;
  }
  return is_short ? sum : kNever;
}

/// Whether a bead would all but stand still while a rotary joint turns (`slowPassages`).
bool LadderSearch::standsStill(const double* from, const double* to, const StationMotion& motion) const {
  if (motion.way != StationWay::Deposition || motion.length_mm <= kInPlace) return false;
  const double most_s = settings_.max_slowdown * motion.duration_s;
  for (std::size_t j = 0; j < ranges_.size(); ++j)
    if (ranges_[j].is_rotary &&
        std::abs(stepBetween(ranges_[j], from[j], to[j])) > most_s * ranges_[j].max_speed)
      return true;
  return false;
}

/// Of turning the yaw from one sample of a row to another.
double LadderSearch::yawCost(int from, int to) const {
  return yaw_costs_[static_cast<std::size_t>(std::abs(from - to))];
}

void LadderSearch::setYawCosts(const Rung& rung) {
  const auto per_row = static_cast<std::size_t>(samplesPerRow(rung));
  if (rung.kind != SampleKind::Yaw || yaw_costs_.size() == per_row) return;
  yaw_costs_.resize(per_row);
  for (std::size_t apart = 0; apart < per_row; ++apart) {
    const double yaw =
        2.0 * M_PI * static_cast<double>(std::min(apart, per_row - apart)) / static_cast<double>(per_row);
    yaw_costs_[apart] = settings_.yaw_weight * yaw * yaw;
  }
}

void LadderSearch::tryEdge(const Target& target, const Departure& from, Reached& best) const {
  if (!(cost_[from.slot] < best.cost)) return;
  const double* const start = before_.at(from.slot);
  const double* const end = target.rung.at(target.slot);
  const StationMotion& motion = target.motion;
  double turns = edge(start, end, motion.way == StationWay::Deposition ? 1.0 : kNever);
  if (target.rung.kind == SampleKind::Yaw) turns += yawCost(from.in_row, target.in_row);
  double cost = cost_[from.slot] + turns / motion.duration_s;
  if (!(cost < best.cost)) return;
  const bool is_into = target.rung.kind == SampleKind::FreeJoint;
  const bool is_from = before_.kind == SampleKind::FreeJoint;
  if (is_into != is_from && motion.way == StationWay::Deposition)
    cost += kIntoSingularity * turns / motion.duration_s;
  if ((is_into || is_from) && standsStill(start, end, motion))
    cost += kStandingStill * turns / motion.duration_s;
  if (!(cost < best.cost)) return;
  if (branchOf(from.id) != target.branch && !crossing_(start, end)) return;
  best = {cost, from.id};
}

/// How many samples of a row a rung alike may be away. With `yaw_reach` alone, half a turn takes so many
/// rungs that a joint which is free for fewer would turn at their ends, where it leads the tip already.
int LadderSearch::reachOf(const Rung& rung) const {
  const int per_row = samplesPerRow(rung);
  const bool is_short_of_room = free_rungs_ * settings_.yaw_reach < per_row / 2;
  return rung.kind == SampleKind::FreeJoint && is_short_of_room ? per_row : settings_.yaw_reach;
}

void LadderSearch::reach(const Target& target, Reached& best) const {
  const int per_row = samplesPerRow(before_);
  const bool is_alike = areAlike(before_, target.rung);
  const int sample = sampleOf(target.rung.idOf(target.slot));
  const Window rows = windowAbout(sample / per_row, before_.rows, is_alike ? kRowReach : before_.rows);
  const Window in_row = windowAbout(sample % per_row, per_row, is_alike ? reachOf(before_) : per_row);
  for (int r = 0; r < rows.count; ++r) {
    const int row = (rows.first + r) % before_.rows;
    for (int s = 0; s < in_row.count; ++s)
      reachFrom(target, row * per_row + (in_row.first + s) % per_row, best);
  }
}

/// From all nodes of a sample that may be joined to a node.
void LadderSearch::reachFrom(const Target& target, int sample, Reached& best) const {
  const int in_row = sample % target.per_row;
  const auto tryFrom = [&](int branch) {
    tryEdge(target, {before_.slot(sample, branch), nodeId(sample, branch), in_row}, best);
  };
  if (target.branch < before_.branches) tryFrom(target.branch);
  if (!crossing_ || target.rung.kind == SampleKind::Yaw) return;
  for (int branch = 0; branch < before_.branches; ++branch)
    if (branch != target.branch) tryFrom(branch);
}

/// The nodes that a travel may set out from.
std::vector<std::size_t> LadderSearch::departures(std::size_t nodes) const {
  std::vector<std::size_t> all;
  std::vector<std::size_t> cheapest(static_cast<std::size_t>(before_.branches), cost_.size());
  for (std::size_t slot = 0; slot < cost_.size(); ++slot) {
    if (!(cost_[slot] < kNever)) continue;
    all.push_back(slot);
    std::size_t& best = cheapest[slot % cheapest.size()];
    if (best == cost_.size() || cost_[slot] < cost_[best]) best = slot;
  }
  if (all.size() * nodes <= kMostTravelEdges) return all;
  cheapest.erase(std::remove(cheapest.begin(), cheapest.end(), cost_.size()), cheapest.end());
  return cheapest;
}

void LadderSearch::overTravel(const Rung& rung, const StationMotion& motion,
                              std::vector<Reached>& reached) const {
  const std::vector<std::size_t> from_slots = departures(reached.size());
  const int per_row = samplesPerRow(rung);
  const bool is_turned = rung.kind == SampleKind::Yaw && areAlike(before_, rung);
  for (std::size_t slot = 0; slot < reached.size(); ++slot) {
    if (!exists(rung, slot)) continue;
    const int in_row = sampleOf(rung.idOf(slot)) % per_row;
    for (const std::size_t from : from_slots) {
      double turns = edge(before_.at(from), rung.at(slot), kNever);
      if (is_turned) turns += yawCost(sampleOf(before_.idOf(from)) % per_row, in_row);
      const double cost = cost_[from] + settings_.branch_change_cost + turns / motion.duration_s;
      if (cost < reached[slot].cost) reached[slot] = {cost, before_.idOf(from)};
    }
  }
}

/// All nodes of a rung, within branches and over steady crossings.
void LadderSearch::reachAll(const Rung& rung, const StationMotion& motion,
                            std::vector<Reached>& reached) const {
  const int per_row = samplesPerRow(rung);
  for (std::size_t slot = 0; slot < reached.size(); ++slot) {
    if (!exists(rung, slot)) continue;
    const NodeId id = rung.idOf(slot);
    reach({rung, slot, branchOf(id), sampleOf(id) % per_row, per_row, motion}, reached[slot]);
  }
}

LadderSearch::Link LadderSearch::advance(Rung rung, const StationMotion& motion) {
  records_.push_back({back_.size(), kNoNode, static_cast<std::uint8_t>(rung.branches)});
  const bool is_first = before_.penalty.empty();
  if (!hasNodes(rung)) {
    if (!is_first) finishBefore();
    before_ = Rung();
    return Link::Empty;
  }
  std::vector<Reached> reached(rung.penalty.size(), {kNever, kNoNode});
  setYawCosts(rung);
  if (!is_first) {
    reachAll(rung, motion, reached);
    if (motion.way == StationWay::ClearTravel && settings_.branch_change == BranchChange::OnTravel)
      overTravel(rung, motion, reached);
  }
  const bool is_joined =
      std::any_of(reached.begin(), reached.end(), [](const Reached& r) { return r.cost < kNever; });
  if (!is_joined && !is_first) {
    cut_ = cutBefore(rung);
    finishBefore();
  }
  cost_.resize(reached.size());
  for (std::size_t slot = 0; slot < reached.size(); ++slot) {
    const double before = is_joined ? reached[slot].cost : 0.0;
    cost_[slot] = before + rung.penalty[slot] * motion.duration_s;
    back_.push_back(reached[slot].from);
  }
  free_rungs_ = rung.kind == SampleKind::FreeJoint ? free_rungs_ + 1 : 0;
  before_ = std::move(rung);
  if (is_first) return Link::Start;
  return is_joined ? Link::Joined : Link::Cut;
}

/// The way so far ends at the cheapest node of the rung before the newest one.
void LadderSearch::finishBefore() {
  const auto cheapest = std::min_element(cost_.begin(), cost_.end());
  records_[records_.size() - 2].end = before_.idOf(static_cast<std::size_t>(cheapest - cost_.begin()));
}

LadderSearch::Cut LadderSearch::cutBetween(const double* from, const double* to) const {
  Cut cut;
  bool is_near_wound = true;
  for (std::size_t j = 0; j < ranges_.size(); ++j) {
    if (!ranges_[j].is_rotary) continue;
    const double step = stepBetween(ranges_[j], from[j], to[j]);
    is_near_wound &= std::abs(std::remainder(step, 2.0 * M_PI)) <= most_turn_[j];
    if (std::abs(step) > std::abs(cut.turn)) cut = {j, step, false};
  }
  cut.is_wound = is_near_wound && std::abs(cut.turn) > most_turn_[cut.joint];
  return cut;
}

/// What the ladder lacks, stated for the pair of nodes that comes nearest to an edge.
LadderSearch::Cut LadderSearch::cutBefore(const Rung& rung) const {
  Cut least{0, kNever, false};
  for (const std::size_t from : departures(rung.penalty.size()))
    for (std::size_t to = 0; to < rung.penalty.size(); ++to) {
      if (!exists(rung, to) || branchOf(before_.idOf(from)) != branchOf(rung.idOf(to))) continue;
      const Cut cut = cutBetween(before_.at(from), rung.at(to));
      if (std::abs(cut.turn) < std::abs(least.turn)) least = cut;
    }
  return least;
}

std::vector<NodeId> LadderSearch::trace() const {
  std::vector<NodeId> nodes(records_.size(), kNoNode);
  NodeId next = kNoNode;
  if (!before_.penalty.empty()) {
    const auto cheapest = std::min_element(cost_.begin(), cost_.end());
    next = before_.idOf(static_cast<std::size_t>(cheapest - cost_.begin()));
  }
  for (std::size_t i = records_.size(); i-- > 0;) {
    const RungRecord& record = records_[i];
    nodes[i] = record.end == kNoNode ? next : record.end;
    next = kNoNode;
    if (nodes[i] == kNoNode) continue;
    const auto slot = static_cast<std::size_t>(sampleOf(nodes[i])) * record.branches +
                      static_cast<std::size_t>(branchOf(nodes[i]));
    next = back_[record.first_back + slot];
  }
  return nodes;
}

}  // namespace lamina
