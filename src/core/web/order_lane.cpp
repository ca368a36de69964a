// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/order_lane.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostWaiting = 16;

DeskAnswer notGiven(DeskAnswer::Outcome outcome, const std::string& message) {
  DeskAnswer answer;
  answer.outcome = outcome;
  answer.message = message;
  return answer;
}

/// Also an order that nobody has answered may be done.
bool mayMove(DeskAnswer::Outcome outcome) {
  return outcome == DeskAnswer::Outcome::Done || outcome == DeskAnswer::Outcome::Silent ||
         outcome == DeskAnswer::Outcome::Unsure;
}

}  // namespace

struct OrderLane::Waiting {
  LaneOrder order;
  std::optional<DeskAnswer> answer;
  bool is_under_way = false;
  int askers = 1;
  std::vector<LaneOrder> stops;  ///< that were asked for while it was being given, one of each kind
};

DeskAnswer OrderLane::overtaken(const Waiting& waiting) {
  std::vector<std::string> kinds;
  kinds.reserve(waiting.stops.size());
  for (const LaneOrder& stop : waiting.stops) kinds.push_back(stop.kind);
  const bool is_one = kinds.size() == 1;
  return notGiven(DeskAnswer::Outcome::Overtaken,
                  waiting.order.kind + " was on its way when " + listed(kinds, " and ") +
                      (is_one ? " was asked for, which was" : " were asked for, which were") +
                      " given after it once more");
}

OrderLane::OrderLane() : thread_([this] { run(); }) {}

OrderLane::~OrderLane() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::shared_ptr<OrderLane::Waiting> OrderLane::ofKind(const std::string& kind) const {
  const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const auto& waiting) { return waiting->order.kind == kind; });
  return found == waiting_.end() ? nullptr : *found;
}

DeskAnswer OrderLane::ask(LaneOrder order) {
  const std::string node = order.node;
  const double patience_s = order.patience_s;
  std::unique_lock<std::mutex> lock(mutex_);
  std::shared_ptr<Waiting> waiting = ofKind(order.kind);
  if (waiting && order.effect != OrderEffect::Stops)
    return notGiven(DeskAnswer::Outcome::Overtaken,
                    order.kind + " was not given: another waits for " + node + " already");
  if (!waiting && waiting_.size() >= kMostWaiting)
    return notGiven(DeskAnswer::Outcome::Overtaken,
                    order.kind + " was not given: " + std::to_string(waiting_.size()) + " orders wait for " +
                        node + "; expected at most " + std::to_string(kMostWaiting));
  if (waiting) {
    ++waiting->askers;
  } else {
    waiting = std::make_shared<Waiting>();
    waiting->order = std::move(order);
    waiting_.push_back(waiting);
    changed_.notify_all();
  }
  changed_.wait_for(lock, std::chrono::duration<double>(patience_s),
                    [&] { return waiting->answer || is_ending_; });
  --waiting->askers;
  if (waiting->answer) return *waiting->answer;
  if (waiting->is_under_way)
    return notGiven(DeskAnswer::Outcome::Unsure, node + " has not answered; it may still do what was asked");
  if (waiting->askers > 0)
    return notGiven(DeskAnswer::Outcome::Unsure, node + " has not answered; somebody else asks it the same");
  waiting_.erase(std::remove(waiting_.begin(), waiting_.end(), waiting), waiting_.end());
  return notGiven(DeskAnswer::Outcome::Silent, node + " has not answered; nothing was asked of it");
}

void OrderLane::post(LaneOrder order) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ofKind(order.kind)) return;
  waiting_.push_back(std::make_shared<Waiting>());
  waiting_.back()->order = std::move(order);
  changed_.notify_all();
}

void OrderLane::dropMoves(const LaneOrder& stop) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (under_way_ && under_way_->order.effect == OrderEffect::Moves) {
    // A start-up's Abort and a Stop of the unit stop different things: the one does not replace the other.
    auto& stops = under_way_->stops;
    const auto same = std::find_if(stops.begin(), stops.end(),
                                   [&stop](const LaneOrder& other) { return other.kind == stop.kind; });
    if (same != stops.end()) stops.erase(same);
    stops.push_back(stop);
  }
  for (const auto& waiting : waiting_)
    if (waiting->order.effect == OrderEffect::Moves)
      waiting->answer = notGiven(DeskAnswer::Outcome::Overtaken,
                                 waiting->order.kind + " was not given: overtaken by " + stop.kind);
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                [](const auto& waiting) { return waiting->answer.has_value(); }),
                 waiting_.end());
  changed_.notify_all();
}

std::size_t OrderLane::waiting() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.size();
}

void OrderLane::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_ending_ || !waiting_.empty(); });
    if (is_ending_) return;
    const auto waiting = std::move(waiting_.front());
    waiting_.pop_front();
    waiting->is_under_way = true;
    under_way_ = waiting;
    lock.unlock();
    DeskAnswer answer = waiting->order.call();
    lock.lock();
    under_way_.reset();
    if (!waiting->stops.empty() && mayMove(answer.outcome)) {
      lock.unlock();
      for (const LaneOrder& stop : waiting->stops) static_cast<void>(stop.call());
      lock.lock();
      answer = overtaken(*waiting);
    }
    waiting->answer = answer;
    changed_.notify_all();
  }
}

}  // namespace lamina
