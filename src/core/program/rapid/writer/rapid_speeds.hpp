// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lamina/program/rapid/rapid_settings.hpp"
#include "program/rapid/writer/rapid_plan.hpp"

namespace lamina {

/// Names of a program's feeds. The first feed of deposition and that of travel have the names of the
/// settings, further feeds have these names with a number. A predefined name of RAPID stands for its own feed
/// only.
class RapidSpeeds {
 public:
  /// A speed that must be declared.
  struct Declared {
    std::string name;
    double feed_mm_s = 0.0;
  };

  /// @throws InvalidConfig if the settings use a predefined name for another feed
  RapidSpeeds(const std::vector<RapidPath>& paths, const RapidSettings& settings);

  const std::string& deposition(double feed_mm_s) const;
  const std::string& air(double feed_mm_s) const;
  /// Name of the speed of moves that lead to the start of a path: the feed of the first travel, or of the
  /// first path if there is no travel.
  const std::string& approach() const { return *approach_; }
  const std::vector<Declared>& declared() const { return declared_; }

 private:
  using Names = std::map<std::int64_t, std::string>;
  void add(double feed_mm_s, const std::string& key, const std::string& name, Names& names);

  Names deposition_;
  Names air_;
  const std::string* approach_ = nullptr;
  std::vector<Declared> declared_;
};

}  // namespace lamina
