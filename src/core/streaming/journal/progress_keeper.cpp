// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/journal/progress_keeper.hpp"

#include <chrono>
#include <exception>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

ProgressKeeper::ProgressKeeper(Write write, double patience_s, const std::optional<JobProgress>& written)
    : patience_s_(patience_s), shared_(std::make_shared<Shared>()) {
  shared_->write = std::move(write);
  shared_->written = written;
  thread_ = std::thread([shared = shared_] { run(*shared); });
}

ProgressKeeper::~ProgressKeeper() {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  shared_->is_over = true;
  shared_->has_changed.notify_all();
  const std::chrono::duration<double> patience(is_given_up_ ? 0.0 : patience_s_);
  const bool has_ended = shared_->has_changed.wait_for(lock, patience, [this] { return shared_->has_ended; });
  lock.unlock();
  if (has_ended)
    thread_.join();
  else
    thread_.detach();
}

void ProgressKeeper::run(Shared& shared) {
  writeAll(shared);
  {
    const std::lock_guard<std::mutex> lock(shared.mutex);
    shared.has_ended = true;
  }
  shared.has_changed.notify_all();
}

/// Until the keeper is over, or the disk fails.
void ProgressKeeper::writeAll(Shared& shared) {
  std::unique_lock<std::mutex> lock(shared.mutex);
  while (shared.failure.empty()) {
    shared.has_changed.wait(lock, [&shared] { return shared.wanted || shared.is_over; });
    if (!shared.wanted) return;
    const JobProgress progress = *std::exchange(shared.wanted, std::nullopt);
    shared.since_s = shared.wanted_s;
    lock.unlock();
    std::string failure;
    try {
      shared.write(progress);
    } catch (const std::exception& error) {  // of a file system too: the process must outlive a bad disk
      failure = error.what();
    }
    lock.lock();
    shared.since_s.reset();
    shared.failure = failure;
    if (failure.empty()) shared.written = progress;
    shared.has_changed.notify_all();
  }
}

void ProgressKeeper::keep(const JobProgress& progress, double now) {
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    if (is_given_up_) return;
    shared_->wanted = progress;
    shared_->wanted_s = now;
  }
  shared_->has_changed.notify_all();
}

bool ProgressKeeper::hasWritten() const {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  return shared_->written.has_value();
}

std::string ProgressKeeper::failure(double now) {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  if (!shared_->failure.empty()) return shared_->failure;
  if (!shared_->since_s || now - *shared_->since_s <= patience_s_) return {};
  return giveUp();
}

void ProgressKeeper::await(const std::function<bool(const JobProgress& written)>& isEnough) {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  const auto isAnswered = [&] {
    return !shared_->failure.empty() || (shared_->written && isEnough(*shared_->written));
  };
  if (!shared_->has_changed.wait_for(lock, std::chrono::duration<double>(patience_s_), isAnswered))
    throw FileError(giveUp());
  if (!shared_->failure.empty()) throw FileError(shared_->failure);
}

/// The mutex is held.
std::string ProgressKeeper::giveUp() {
  is_given_up_ = true;
  // What is known by then is old when the disk answers.
  shared_->wanted.reset();
  return "the progress file was not written within " + numberText(patience_s_) +
         " s: its disk does not answer";
}

}  // namespace lamina
