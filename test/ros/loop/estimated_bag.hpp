// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ros/bag_player.hpp"
#include "ros/loop/controlled_wall.hpp"
#include "ros/wait_until.hpp"

namespace lamina::test {

/// What `lamina estimate` says of a bag, with a loop that knows its sensor by `known`.
inline nlohmann::json estimate(const std::string& bag, const std::string& more = "",
                               const std::string& known =
                                   "--set sensor.time_offset_trusted=true "
                                   "--set sensor.place_trusted=true") {
  const std::string command =
      std::string(LAMINA_COMMAND) + " estimate " + bag +
      " --json --set request=active --set sight.sigma_mm=0.01 --set loop.reading_correlation=0 " + known +
      " " + more;
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> part{};
  for (std::size_t read = 0; (read = fread(part.data(), 1, part.size(), pipe)) > 0;)
    text.append(part.data(), read);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return nlohmann::json::parse(text);
}

/// Digests of the maps that a node gives over a bag that is played.
inline std::vector<std::string> replayed(const std::string& bag, std::size_t layers, const std::string& rate,
                                         const std::vector<std::string>& parameters = {}) {
  Controller controller(parameters);
  const BagPlayer player(bag, {"--rate=" + rate, "--delay=0.5"});
  waitUntil([&] { return controller.layers.size() >= layers && controller.maps.size() >= layers; });
  return controller.digests();
}

}  // namespace lamina::test
