// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "node_process.hpp"

namespace lamina::test {

/// Plays a bag to subscribers, and stays until it is destroyed: a player that leaves after the last message
/// takes with it what is still to be sent.
class BagPlayer {
 public:
  explicit BagPlayer(const std::string& bag, const std::vector<std::string>& options = {})
      : process_("/usr/bin/env", argumentsFor(bag, options)) {}

 private:
  static std::vector<std::string> argumentsFor(const std::string& bag,
                                               const std::vector<std::string>& options) {
    std::vector<std::string> all = {
        "rosrun", "rosbag", "play", "--quiet", "--keep-alive", "--queue=100000", "--wait-for-subscribers"};
    all.insert(all.end(), options.begin(), options.end());
    all.push_back(bag);
    return all;
  }

  NodeProcess process_;
};

}  // namespace lamina::test
