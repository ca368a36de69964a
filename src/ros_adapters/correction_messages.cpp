// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "correction_messages.hpp"

#include <cmath>

#include "conversions.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// A multiplication and its inverse change the last bits, which a digest would show.
double rounded(double length) {
  constexpr int kBits = 40;
  if (!std::isfinite(length)) return length;
  int exponent = 0;
  const double mantissa = std::frexp(length, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, kBits)), exponent - kBits);
}

CorrectionMap roundedMap(CorrectionMap map) {
  for (PathCorrection& path : map.paths) {
    path.spacing_mm = rounded(path.spacing_mm);
    for (PointCorrection& place : path.stations) place.dz_mm = rounded(place.dz_mm);
  }
  return map;
}

void requireAsMany(const lamina_msgs::CorrectionPath& path, std::size_t values, const char* what) {
  if (values == path.amount.size()) return;
  throw InvalidInput("correction of path " + std::to_string(path.path) + ": " + std::to_string(values) + " " +
                     what + " to " + std::to_string(path.amount.size()) +
                     " amounts; expected as many of each");
}

PathCorrection pathOf(const lamina_msgs::CorrectionPath& message) {
  requireAsMany(message, message.speed.size(), "speeds");
  requireAsMany(message, message.dz.size(), "heights");
  PathCorrection path{message.path, toMillimetres(message.station), {}};
  path.stations.reserve(message.amount.size());
  for (std::size_t i = 0; i < message.amount.size(); ++i)
    path.stations.push_back({message.amount[i], message.speed[i], toMillimetres(message.dz[i])});
  return path;
}

}  // namespace

lamina_msgs::CorrectionMap toMessage(const CorrectionMap& map) {
  const CorrectionMap sent = roundedMap(map);
  lamina_msgs::CorrectionMap message;
  message.toolpath_id = sent.toolpath_id;
  message.layer = static_cast<std::uint32_t>(sent.layer);
  message.sequence = sent.sequence;
  message.digest = digestOf(sent);
  for (const PathCorrection& path : sent.paths) {
    message.paths.emplace_back();
    lamina_msgs::CorrectionPath& corrected = message.paths.back();
    corrected.path = static_cast<std::uint32_t>(path.path);
    corrected.station = toMetres(path.spacing_mm);
    for (const PointCorrection& place : path.stations) {
      corrected.amount.push_back(place.amount);
      corrected.speed.push_back(place.speed);
      corrected.dz.push_back(toMetres(place.dz_mm));
    }
  }
  message.ahead_interval = sent.ahead.interval_s;
  message.ahead = sent.ahead.amount;
  return message;
}

CorrectionMap toCore(const lamina_msgs::CorrectionMap& message) {
  CorrectionMap map{message.toolpath_id, message.layer, message.sequence, {}};
  map.paths.reserve(message.paths.size());
  for (const lamina_msgs::CorrectionPath& path : message.paths) map.paths.push_back(pathOf(path));
  map.ahead = {message.ahead_interval, message.ahead};
  map = roundedMap(std::move(map));
  validate(map);
  if (digestOf(map) != message.digest)
    throw InvalidInput("correction of layer " + std::to_string(map.layer) + ": the digest is '" +
                       message.digest + "'; the map's is '" + digestOf(map) + "'");
  return map;
}

lamina_msgs::AppliedCorrection toMessage(const MissedMap& missed, const std::string& toolpath_id,
                                         const std::string& digest) {
  lamina_msgs::AppliedCorrection message;
  message.toolpath_id = toolpath_id;
  message.layer = static_cast<std::uint32_t>(missed.layer);
  message.digest = digest;
  message.waited = missed.waited_s;
  message.reason = missed.reason;
  if (!missed.held_from) return message;
  message.from_path = static_cast<std::uint32_t>(missed.held_from->path);
  message.from_along = toMetres(missed.held_from->along_mm);
  return message;
}

std::optional<MissedMap> missedOf(const lamina_msgs::AppliedCorrection& message) {
  MissedMap missed{message.layer, message.waited, message.reason, {}};
  if (message.digest.empty()) return missed;
  if (!message.reason.empty()) return std::nullopt;
  missed.held_from = PlaceOnLayer{message.from_path, toMillimetres(message.from_along)};
  return missed;
}

MissedMap refusedPlan(const std::string& reason) {
  return {0, 0.0, "the plan is not gone on with: " + reason, {}};
}

bool isRefusalOfPlan(const lamina_msgs::AppliedCorrection& message) {
  return message.layer == 0 && message.digest.empty() && message.waited == 0.0 && !message.reason.empty();
}

}  // namespace lamina
