// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/writer/rapid_speeds.hpp"

#include <cmath>
#include <optional>

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"
#include "program/rapid/rapid_words.hpp"

namespace lamina {
namespace {

/// Feeds are distinguished as far as they are written.
std::int64_t unitsOf(double feed_mm_s) { return std::llround(feed_mm_s * 1e3); }

double approachFeed(const std::vector<RapidPath>& paths) {
  for (const RapidPath& path : paths)
    if (!path.deposits()) return path.path->feed_mm_s.at(path.path->motionEnd(0));
  return paths.front().path->feed_mm_s.at(paths.front().path->motionEnd(0));
}

}  // namespace

RapidSpeeds::RapidSpeeds(const std::vector<RapidPath>& paths, const RapidSettings& settings) {
  const double approach = approachFeed(paths);
  add(approach, "rapid.air_speed", settings.air_speed, air_);
  approach_ = &air_.at(unitsOf(approach));
  for (const RapidPath& path : paths) {
    const auto& feeds = path.path->feed_mm_s.values();
    // What stands at waypoint 0 of an open path is not used.
    const std::size_t first = feeds.size() > 1 && !path.path->is_closed ? 1 : 0;
    for (std::size_t i = first; i < feeds.size(); ++i) {
      if (path.deposits())
        add(feeds[i], "rapid.deposition_speed", settings.deposition_speed, deposition_);
      else
        add(feeds[i], "rapid.air_speed", settings.air_speed, air_);
    }
  }
}

const std::string& RapidSpeeds::deposition(double feed_mm_s) const {
  return deposition_.at(unitsOf(feed_mm_s));
}
const std::string& RapidSpeeds::air(double feed_mm_s) const { return air_.at(unitsOf(feed_mm_s)); }

void RapidSpeeds::add(double feed_mm_s, const std::string& key, const std::string& name, Names& names) {
  const std::int64_t units = unitsOf(feed_mm_s);
  if (names.count(units) != 0) return;
  if (const std::optional<double> own = rapidSpeed(name)) {
    if (unitsOf(*own) != units)
      throw InvalidConfig(key + " is " + name + ", which is " + decimalText(*own, 3) +
                          " mm/s, but the toolpath has a feed of " + decimalText(feed_mm_s, 3) +
                          " mm/s; expected that feed alone, or a name that RAPID does not know");
    names.emplace(units, name);
    return;
  }
  const std::string numbered = names.empty() ? name : name + "_" + std::to_string(names.size() + 1);
  requireRapidName(key, numbered);
  names.emplace(units, numbered);
  declared_.push_back({numbered, static_cast<double>(units) * 1e-3});
}

}  // namespace lamina
