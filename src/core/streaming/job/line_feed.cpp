// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/line_feed.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/motion_time.hpp"

namespace lamina {
namespace {

/// Reads lines a thousand ahead in a thread of its own.
class ReadAhead {
 public:
  ReadAhead(LineFeed::Source source, std::function<bool()> hasChanged, double patience_s);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// The next line; waits for it if necessary. None at the end, and from when it was waited for in vain.
  std::optional<ProgramLine> next();

 private:
  using Batch = std::vector<ProgramLine>;

  /// What the thread works on. It outlives the reader if the disk does not answer, since a thread that waits
  /// for a disk cannot be ended.
  struct Shared {
    LineFeed::Source source;            ///< of the thread alone
    std::function<bool()> has_changed;  ///< of the thread alone
    std::mutex mutex;                   ///< of everything below
    std::condition_variable changed;
    std::deque<Batch> read;
    bool is_over = false;  ///< nothing more is read, or wanted
    bool has_ended = false;
  };

  static void run(Shared& shared);
  static Batch readBatch(Shared& shared);
  static bool hand(Shared& shared, Batch batch);

  std::shared_ptr<Shared> shared_;
  std::chrono::duration<double> patience_;
  Batch current_;
  std::size_t given_ = 0;  ///< lines of the current batch
  std::thread thread_;
};

constexpr std::size_t kBatchLines = 128;
constexpr std::size_t kBatches = 8;
constexpr std::chrono::seconds kLongestEnd{1};

ReadAhead::ReadAhead(LineFeed::Source source, std::function<bool()> hasChanged, double patience_s)
    : shared_(std::make_shared<Shared>()), patience_(patience_s) {
  shared_->source = std::move(source);
  shared_->has_changed = std::move(hasChanged);
  thread_ = std::thread([shared = shared_] { run(*shared); });
}

ReadAhead::~ReadAhead() {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  shared_->is_over = true;
  shared_->changed.notify_all();
  // Whoever stops a machine must not wait for a disk.
  const bool has_ended = shared_->changed.wait_for(lock, kLongestEnd, [this] { return shared_->has_ended; });
  lock.unlock();
  if (has_ended)
    thread_.join();
  else
    thread_.detach();
}

std::optional<ProgramLine> ReadAhead::next() {
  if (given_ == current_.size()) {
    std::unique_lock<std::mutex> lock(shared_->mutex);
    const auto isKnown = [this] { return !shared_->read.empty() || shared_->is_over; };
    if (!shared_->changed.wait_for(lock, patience_, isKnown)) shared_->is_over = true;
    if (shared_->read.empty()) return std::nullopt;
    current_ = std::move(shared_->read.front());
    shared_->read.pop_front();
    given_ = 0;
    lock.unlock();
    shared_->changed.notify_all();
  }
  return std::move(current_[given_++]);
}

void ReadAhead::run(Shared& shared) {
  while (true) {
    Batch batch = readBatch(shared);
    // Read before it was looked at, so that nothing unchecked is in it; looked at once, so that what is left
    // out is the end.
    const bool has_changed = shared.has_changed();
    const bool is_last = has_changed || batch.size() < kBatchLines;
    if (has_changed) batch.clear();
    if (!hand(shared, std::move(batch)) || is_last) break;
  }
  {
    const std::lock_guard<std::mutex> lock(shared.mutex);
    shared.is_over = shared.has_ended = true;
  }
  shared.changed.notify_all();
}

ReadAhead::Batch ReadAhead::readBatch(Shared& shared) {
  Batch batch;
  batch.reserve(kBatchLines);
  while (batch.size() < kBatchLines) {
    auto line = shared.source();
    if (!line) break;
    batch.push_back(std::move(*line));
  }
  return batch;
}

/// @return false if no more is wanted
bool ReadAhead::hand(Shared& shared, Batch batch) {
  std::unique_lock<std::mutex> lock(shared.mutex);
  shared.changed.wait(lock, [&shared] { return shared.read.size() < kBatches || shared.is_over; });
  if (shared.is_over) return false;
  if (!batch.empty()) shared.read.push_back(std::move(batch));
  lock.unlock();
  shared.changed.notify_all();
  return true;
}

/// Read where it is asked for.
LineFeed::Source linesOf(const StreamableProgram& program) {
  return [cursor = std::make_shared<ProgramCursor>(program.open()),
          time = std::make_shared<MotionTime>()]() -> std::optional<ProgramLine> {
    auto line = cursor->next();
    if (line) line->seconds = time->secondsOf(line->command);
    return line;
  };
}

// Far more than any window: firmware asks for lines it has just missed.
constexpr std::size_t kRememberedLines = 1024;

}  // namespace

LineFeed::Source readAhead(LineFeed::Source source, std::function<bool()> hasChanged, double patience_s) {
  return [ahead = std::make_shared<ReadAhead>(std::move(source), std::move(hasChanged), patience_s)] {
    return ahead->next();
  };
}

LineFeed::Source sourceOf(const StreamableProgram& program) {
  if (program.isHeld()) return linesOf(program);
  return readAhead(
      linesOf(program), [program] { return program.hasChanged(); }, kLongestRead);
}

LineFeed::Source restOf(const StreamableProgram& program, std::uint64_t lines_left_out,
                        const std::function<void(const ProgramLine&)>& passed) {
  LineFeed::Source source = sourceOf(program);
  for (std::uint64_t i = 0; i < lines_left_out; ++i)
    if (const auto line = source()) passed(*line);
  return source;
}

LineFeed::Source sourceOf(std::vector<std::string> commands) {
  std::reverse(commands.begin(), commands.end());
  return [left = std::move(commands)]() mutable -> std::optional<ProgramLine> {
    if (left.empty()) return std::nullopt;
    ProgramLine line{left.back(), -1, 0.0};
    left.pop_back();
    return line;
  };
}

const ProgramLine* LineFeed::peek() {
  const std::size_t index = next_ - first_kept_;
  if (index < kept_.size()) return &kept_[index];
  auto line = source_();
  if (!line) return nullptr;
  kept_.push_back(std::move(*line));
  has_unsent_ = true;
  return &kept_.back();
}

void LineFeed::advance() {
  if (next_ == end()) has_unsent_ = false;
  ++next_;
  if (kept_.size() <= kRememberedLines) return;
  kept_.pop_front();
  ++first_kept_;
}

bool LineFeed::rewind(std::uint64_t number) {
  if (number < first_kept_ || number > end()) return false;
  next_ = number;
  return true;
}

std::int32_t LineFeed::layerOf(std::uint64_t number) const {
  if (number == line_before_) return layer_before_;
  if (number < first_kept_ || number >= first_kept_ + kept_.size()) return -1;
  return kept_[number - first_kept_].layer;
}

}  // namespace lamina
