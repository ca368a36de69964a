// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/order_lane.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

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
  std::optional<LaneOrder> stop;  ///< that was asked for while it was being given
};

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

void OrderLane::dropMoves(const LaneOrder& stop) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (under_way_ && under_way_->order.effect == OrderEffect::Moves) under_way_->stop = stop;
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
    if (waiting->stop && mayMove(answer.outcome)) {
      lock.unlock();
      static_cast<void>(waiting->stop->call());
      lock.lock();
      answer.outcome = DeskAnswer::Outcome::Overtaken;
      answer.message = waiting->order.kind + " was on its way when " + waiting->stop->kind +
                       " was asked for, which was given after it once more";
    }
    waiting->answer = answer;
    changed_.notify_all();
  }
}

}  // namespace lamina
