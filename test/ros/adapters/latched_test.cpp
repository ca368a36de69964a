// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "latched.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lamina {
namespace {

/// A publisher as roscpp has it: a message goes to the subscribers that are there, and is kept for later ones
/// only after that. Some come in between.
class TopicWithNewcomers {
 public:
  TopicWithNewcomers(std::size_t there, std::size_t newcomers) : received_(there), newcomers_(newcomers) {}

  std::size_t getNumSubscribers() const { return received_.size(); }

  void publish(const std::string& message) const {
    for (std::vector<std::string>& received : received_) received.push_back(message);
    for (; newcomers_ > 0; --newcomers_) subscribe();
    kept_ = message;
  }

  void subscribe() const {
    received_.emplace_back();
    if (!kept_.empty()) received_.back().push_back(kept_);
  }

  const std::vector<std::vector<std::string>>& received() const { return received_; }

 private:
  mutable std::vector<std::vector<std::string>> received_;
  mutable std::size_t newcomers_;
  mutable std::string kept_;
};

using Received = std::vector<std::vector<std::string>>;

TEST(Latched, MessageReachesWhoConnectsWhileItIsPublished) {
  const TopicWithNewcomers topic(1, 2);
  publishLatched(topic, std::string("part"));
  EXPECT_EQ(topic.received(), (Received{{"part", "part"}, {"part"}, {"part"}}));
}

TEST(Latched, MessageComesOnceWhereNobodyConnectsMeanwhile) {
  const TopicWithNewcomers topic(2, 0);
  publishLatched(topic, std::string("part"));
  topic.subscribe();
  EXPECT_EQ(topic.received(), (Received{{"part"}, {"part"}, {"part"}}));
}

}  // namespace
}  // namespace lamina
