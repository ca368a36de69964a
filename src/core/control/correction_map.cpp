// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/correction_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// FNV-1a over 64-bit words.
class MapFingerprint {
 public:
  void add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x100000001B3ULL;
    hash_ ^= hash_ >> 29;
  }
  void add(double value) {
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof word);
    add(word);
  }
  void add(const std::string& text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

[[noreturn]] void refuseStation(const PathCorrection& path, std::size_t station, const std::string& what) {
  throw InvalidInput("correction of path " + std::to_string(path.path) + ", station " +
                     std::to_string(station) + ": " + what);
}

constexpr double kGreatestChange = 5.0;   // of amount and speed, as the law's greatest limit
constexpr double kGreatestShift = 100.0;  // mm
constexpr double kLeastSpacing = 1e-3;    // mm: a thousandth of what sensors resolve along a path

void requireWithin(const PathCorrection& path, std::size_t station, const char* what, double change) {
  if (change <= -1.0 || change > kGreatestChange)
    refuseStation(path, station,
                  std::string("the ") + what + " changes by " + numberText(change) +
                      "; expected more than -1 and at most " + numberText(kGreatestChange));
}

void requireStations(const PathCorrection& path) {
  if (!(path.spacing_mm > 0.0) || !std::isfinite(path.spacing_mm))
    refuseStation(path, 0,
                  "stations are " + numberText(path.spacing_mm) + " mm apart; expected a positive distance");
  // Layers are divided as densely as their maps are.
  if (path.stations.size() > 1 && path.spacing_mm < kLeastSpacing)
    refuseStation(path, 0,
                  "stations are " + numberText(path.spacing_mm) + " mm apart; expected at least " +
                      numberText(kLeastSpacing) + " mm");
  if (path.stations.empty()) refuseStation(path, 0, "there is none; expected one at least");
  for (std::size_t i = 0; i < path.stations.size(); ++i) {
    const PointCorrection& place = path.stations[i];
    const bool is_finite =
        std::isfinite(place.amount) && std::isfinite(place.speed) && std::isfinite(place.dz_mm);
    if (!is_finite) refuseStation(path, i, "a value is not finite; expected finite ones");
    requireWithin(path, i, "amount", place.amount);
    requireWithin(path, i, "speed", place.speed);
    if (std::abs(place.dz_mm) > kGreatestShift)
      refuseStation(path, i,
                    "the nozzle is shifted by " + numberText(place.dz_mm) + " mm; expected at most " +
                        numberText(kGreatestShift) + " mm");
  }
}

void requireBeginning(const ExpectedBeginning& ahead) {
  const std::string what = "correction expected of the layer above: ";
  if (ahead.amount.empty()) return;
  if (!(ahead.interval_s > 0.0) || !std::isfinite(ahead.interval_s))
    throw InvalidInput(what + "amounts are " + numberText(ahead.interval_s) +
                       " s apart; expected a positive time");
  for (const double amount : ahead.amount)
    if (!(amount > -1.0 && amount <= kGreatestChange))
      throw InvalidInput(what + "the amount changes by " + numberText(amount) +
                         "; expected more than -1 and at most " + numberText(kGreatestChange));
}

double valueOr(const std::vector<double>& values, std::size_t i) { return values.empty() ? 0.0 : values[i]; }

}  // namespace

bool isNone(const PathCorrection& correction) {
  return std::all_of(correction.stations.begin(), correction.stations.end(),
                     [](const PointCorrection& place) { return place.isNone(); });
}

PointCorrection correctionAt(const PathCorrection& path, double along_mm) {
  if (path.stations.empty()) return {};
  const double place = std::max(0.0, along_mm / path.spacing_mm - 0.5);
  const std::size_t last = path.stations.size() - 1;
  if (place >= static_cast<double>(last)) return path.stations[last];
  const auto i = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(i);
  const PointCorrection& a = path.stations[i];
  const PointCorrection& b = path.stations[i + 1];
  return {a.amount + part * (b.amount - a.amount), a.speed + part * (b.speed - a.speed),
          a.dz_mm + part * (b.dz_mm - a.dz_mm)};
}

CorrectionMap correctionMap(const LayerCells& cells, const CellCorrections& corrections,
                            const std::string& toolpath_id, std::uint64_t sequence) {
  CorrectionMap map{toolpath_id, cells.layer, sequence, {}};
  for (const CellRun& run : cells.runs) {
    PathCorrection path{run.path, run.cellLength(), {}};
    path.stations.reserve(run.count);
    for (std::size_t i = run.first; i < run.first + run.count; ++i)
      path.stations.push_back(
          {valueOr(corrections.amount, i), valueOr(corrections.speed, i), valueOr(corrections.dz_mm, i)});
    map.paths.push_back(std::move(path));
  }
  return map;
}

std::string digestOf(const CorrectionMap& map) {
  MapFingerprint fingerprint;
  fingerprint.add(map.toolpath_id);
  fingerprint.add(static_cast<std::uint64_t>(map.layer));
  fingerprint.add(map.sequence);
  fingerprint.add(static_cast<std::uint64_t>(map.paths.size()));
  for (const PathCorrection& path : map.paths) {
    fingerprint.add(static_cast<std::uint64_t>(path.path));
    fingerprint.add(path.spacing_mm);
    fingerprint.add(static_cast<std::uint64_t>(path.stations.size()));
    for (const PointCorrection& place : path.stations) {
      fingerprint.add(place.amount);
      fingerprint.add(place.speed);
      fingerprint.add(place.dz_mm);
    }
  }
  // Maps without it keep the digest that they had before there was one.
  if (!map.ahead.amount.empty()) {
    fingerprint.add(map.ahead.interval_s);
    fingerprint.add(static_cast<std::uint64_t>(map.ahead.amount.size()));
    for (const double amount : map.ahead.amount) fingerprint.add(amount);
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(fingerprint.value()));
  return text;
}

void validate(const CorrectionMap& map) {
  for (std::size_t p = 0; p < map.paths.size(); ++p) {
    if (p > 0 && map.paths[p].path <= map.paths[p - 1].path)
      refuseStation(
          map.paths[p], 0,
          "it stands after path " + std::to_string(map.paths[p - 1].path) + "; expected paths to ascend");
    requireStations(map.paths[p]);
  }
  requireBeginning(map.ahead);
}

}  // namespace lamina
