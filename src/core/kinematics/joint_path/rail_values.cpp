// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/joint_path/arm_rail.hpp"
#include "kinematics/joint_path/taut_string.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

// Shares of the reach.
constexpr double kNearestShare = 0.35;
constexpr double kBestShare = 0.7;
constexpr double kFarthestShare = 0.9;
constexpr double kStretchedShare = 0.97;
constexpr double kAsideShare = 0.3;

constexpr double kRoundedOver = 0.4;  // s
constexpr double kAlikeSides = 1e-6;  // mm

/// The wrist as seen from the rail [mm].
struct WristPlace {
  double foot = 0.0;    ///< value of the rail at which it is beside the arm
  double aside = 0.0;   ///< distance from the plane that axis 1 passes along
  double height = 0.0;  ///< over the shoulder
};

/// Values of the rail [mm]; none if low > high.
struct RailSpan {
  double low = 0.0;
  double high = 0.0;

  bool isEmpty() const { return low > high; }
};

struct RailRoom {
  RailSpan allowed;
  double best = 0.0;
};

RailSpan sharedSpan(const RailSpan& a, const RailSpan& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// The part of a span within the limits; the limit next to it if there is none.
RailSpan spanInLimits(const RailSpan& span, const JointRange& range) {
  const auto bounded = [&](double value) { return std::max(range.low, std::min(range.high, value)); };
  return {bounded(span.low), bounded(span.high)};
}

/// Area between a line through values and the one at `i`, to one side, over a time.
double areaBeside(const std::vector<double>& at, const std::vector<double>& values, std::size_t i, int side,
                  double time) {
  double area = 0.0;
  double left = time;
  for (std::size_t k = i; left > 0.0 && (side > 0 ? k + 1 < at.size() : k > 0);) {
    const std::size_t next = side > 0 ? k + 1 : k - 1;
    const double length = std::abs(at[next] - at[k]);
    const double share = std::min(1.0, left / length);
    const double reached = values[k] + share * (values[next] - values[k]);
    area += share * length * (0.5 * (values[k] + reached) - values[i]);
    left -= length;
    k = next;
  }
  return area;
}

/// Means over a time, nearer to the ends over less of it, so that both ends stay.
std::vector<double> rounded(const std::vector<double>& at, const std::vector<double>& values) {
  std::vector<double> means = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double half = std::min({0.5 * kRoundedOver, at[i] - at.front(), at.back() - at[i]});
    if (half <= 0.0) continue;
    const double area = areaBeside(at, values, i, 1, half) + areaBeside(at, values, i, -1, half);
    means[i] = values[i] + area / (2.0 * half);
  }
  return means;
}

/// The way of least motion through what is allowed at each station, from a value at the first one on.
std::vector<double> ledThrough(const std::vector<Station>& stations, const std::vector<RailSpan>& allowed,
                               double first) {
  const std::vector<double> at = passedAt(stations);
  std::vector<Gate> gates;
  gates.reserve(allowed.size());
  double value = first;
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    value = std::clamp(value, allowed[i].low, allowed[i].high);
    gates.push_back({at[i], allowed[i].low, allowed[i].high});
  }
  // The end is free: it is where the least motion leads.
  gates.back() = {at.back(), value, value};
  gates.front().low = gates.front().high = first;
  return rounded(at, tautString(gates));
}

/// The wrist of a station, with all that carries the arm at zero; other external axes as they stand there.
WristPlace wristPlace(const ArmRail& rail, const Station& station, const std::vector<std::size_t>& at_zero) {
  JointValues external(static_cast<Eigen::Index>(rail.external_in_station.size()));
  for (Eigen::Index j = 0; j < external.size(); ++j) {
    const std::size_t in_station = rail.external_in_station[static_cast<std::size_t>(j)];
    const bool is_at_zero = std::find(at_zero.begin(), at_zero.end(), in_station) != at_zero.end();
    external[j] = is_at_zero ? 0.0 : station.external.at(in_station);
  }
  const Eigen::Isometry3d nozzle = bedFromNozzle(rail.external, external).inverse() * station.pose();
  const Point3 wrist = nozzle.translation() - rail.wrist_mm * nozzle.linear().col(2) - rail.centre;
  return {rail.along.dot(wrist), rail.up.cross(rail.along).dot(wrist), rail.up.dot(wrist)};
}

/// On which side of the wrist the arm stands: -1 for lesser values of the rail, 1 for greater ones.
using RailSide = double;

class RailLeading {
 public:
  RailLeading(const ArmRail& rail, const std::vector<Station>& stations) : rail_(rail), stations_(stations) {
    places_.reserve(stations.size());
    for (const Station& station : stations) {
      places_.push_back(placeOf(station));
      requireWithinLimits(station, places_.back());
    }
    const double behind = outsideLimits(-1.0);
    const RailSide side = outsideLimits(1.0) < behind - kAlikeSides ? 1.0 : -1.0;
    rooms_.reserve(stations.size());
    for (const WristPlace& place : places_) {
      const RailRoom room = roomOn(side, place);
      const RailSpan allowed = spanInLimits(room.allowed, rail_.range);
      rooms_.push_back({allowed, std::clamp(room.best, allowed.low, allowed.high)});
    }
  }

  std::vector<double> following() const {
    std::vector<RailSpan> allowed;
    allowed.reserve(rooms_.size());
    for (const RailRoom& room : rooms_) allowed.push_back(room.allowed);
    return ledThrough(stations_, allowed, rooms_.front().best);
  }

  std::vector<double> stepping() const {
    const std::vector<BeadRun> runs = beadRuns();
    std::vector<double> values(stations_.size(), rooms_.front().best);
    if (runs.empty()) return values;
    const std::vector<double> stands = standsOf(runs);
    const std::vector<double> at = passedAt(stations_);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::size_t begin = r == 0 ? 0 : runs[r].first;
      const std::size_t end = r + 1 == runs.size() ? stations_.size() - 1 : runs[r].last;
      std::fill(values.begin() + static_cast<std::ptrdiff_t>(begin),
                values.begin() + static_cast<std::ptrdiff_t>(end) + 1, stands[r]);
      if (r == 0) continue;
      const std::size_t left = runs[r - 1].last;
      const double slope = (stands[r] - stands[r - 1]) / (at[begin] - at[left]);
      for (std::size_t i = left + 1; i < begin; ++i) values[i] = stands[r - 1] + slope * (at[i] - at[left]);
    }
    return values;
  }

 private:
  /// Stations between which there is no travel.
  struct BeadRun {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  WristPlace placeOf(const Station& station) const { return wristPlace(rail_, station, {rail_.in_station}); }

  /// How far to either side of the foot the wrist is no farther than that from the shoulder.
  std::optional<double> halfWithin(const WristPlace& place, double distance_mm) const {
    if (std::abs(place.height) > distance_mm) return std::nullopt;
    const double level =
        rail_.shoulder_mm + std::sqrt(distance_mm * distance_mm - place.height * place.height);
    if (std::abs(place.aside) > level) return std::nullopt;
    return std::sqrt(level * level - place.aside * place.aside);
  }

  RailSpan spanWithin(const WristPlace& place, double distance_mm) const {
    const double half = halfWithin(place, distance_mm).value_or(0.0);
    return {place.foot - half, place.foot + half};
  }

  RailRoom roomOn(RailSide side, const WristPlace& place) const {
    RailSpan allowed = spanWithin(place, kFarthestShare * rail_.reach_mm);
    if (const auto inner = halfWithin(place, kNearestShare * rail_.reach_mm))
      (side < 0.0 ? allowed.high : allowed.low) = place.foot + side * *inner;
    const double best = halfWithin(place, kBestShare * rail_.reach_mm).value_or(0.0);
    return {allowed, place.foot + side * best};
  }

  /// By how much the limits keep the rail from standing on a side, over all stations [mm].
  double outsideLimits(RailSide side) const {
    double outside = 0.0;
    for (const WristPlace& place : places_) {
      const RailSpan allowed = roomOn(side, place).allowed;
      outside += std::max({0.0, rail_.range.low - allowed.high, allowed.low - rail_.range.high});
    }
    return outside;
  }

  std::string limitsText() const {
    return "its limits, " + jointValueText(rail_.range, rail_.range.low) + " to " +
           jointValueText(rail_.range, rail_.range.high);
  }

  /// What no value brings within reach is left to the search for joints, which names each waypoint.
  void requireWithinLimits(const Station& station, const WristPlace& place) const {
    const double most = rail_.reach_mm + rail_.slack_mm;
    if (!halfWithin(place, most)) return;
    const RailSpan reached = spanWithin(place, most);
    if (!sharedSpan(reached, {rail_.range.low, rail_.range.high}).isEmpty()) return;
    const double needed = reached.low > rail_.range.high ? reached.low : reached.high;
    throw Unreachable("arm '" + rail_.arm + "': joint '" + rail_.joint + "' would have to stand at " +
                      jointValueText(rail_.range, needed) + " to reach " + placeText(station) +
                      "; expected " + limitsText());
  }

  static std::string placeText(const Station& station) {
    const Point3& tip = station.position;
    return "(" + numberText(tip.x()) + ", " + numberText(tip.y()) + ", " + numberText(tip.z()) +
           ") mm over the bed";
  }

  std::vector<BeadRun> beadRuns() const {
    std::vector<BeadRun> runs;
    for (std::size_t i = 1; i < stations_.size(); ++i) {
      if (stations_[i].motion.way != StationWay::Deposition) continue;
      if (runs.empty() || runs.back().last + 1 != i) runs.push_back({i - 1, i});
      runs.back().last = i;
    }
    return runs;
  }

  /// Where the rail may stand during a run.
  RailRoom roomOf(const BeadRun& run) const {
    RailRoom room{{rail_.range.low, rail_.range.high}, 0.0};
    RailSpan stretched = room.allowed;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      room.allowed = sharedSpan(room.allowed, rooms_[i].allowed);
      room.best += rooms_[i].best / static_cast<double>(run.last - run.first + 1);
      stretched = sharedSpan(
          stretched, spanInLimits(spanWithin(places_[i], kStretchedShare * rail_.reach_mm), rail_.range));
    }
    if (!room.allowed.isEmpty()) return room;
    if (stretched.isEmpty())
      throw Unreachable("arm '" + rail_.arm + "': joint '" + rail_.joint +
                        "' would have to move along the bead from " + placeText(stations_[run.first]) +
                        " to " + placeText(stations_[run.last]) +
                        ", and joints.rail steps moves it on travels only; expected shorter beads, or "
                        "joints.rail follow");
    room.allowed = stretched;
    return room;
  }

  /// A value for each run: the same for as many as possible.
  std::vector<double> standsOf(const std::vector<BeadRun>& runs) const {
    std::vector<double> stands(runs.size(), 0.0);
    for (std::size_t first = 0; first < runs.size();) {
      RailRoom shared = roomOf(runs[first]);
      double sum = shared.best;
      std::size_t next = first + 1;
      for (; next < runs.size(); ++next) {
        const RailRoom room = roomOf(runs[next]);
        const RailSpan both = sharedSpan(shared.allowed, room.allowed);
        if (both.isEmpty()) break;
        shared.allowed = both;
        sum += room.best;
      }
      const double mean = sum / static_cast<double>(next - first);
      for (; first < next; ++first) stands[first] = std::clamp(mean, shared.allowed.low, shared.allowed.high);
    }
    return stands;
  }

  const ArmRail& rail_;
  const std::vector<Station>& stations_;
  std::vector<WristPlace> places_;
  std::vector<RailRoom> rooms_;
};

}  // namespace

std::vector<double> railValues(const ArmRail& rail, const std::vector<Station>& stations, RailChoice choice) {
  const RailLeading leading(rail, stations);
  return choice == RailChoice::Steps ? leading.stepping() : leading.following();
}

std::vector<double> crossRailValues(const ArmRail& rail, const CrossRail& across,
                                    const std::vector<Station>& stations) {
  std::vector<RailSpan> allowed;
  allowed.reserve(stations.size());
  double level = 0.0;
  for (const Station& station : stations) {
    const double aside = wristPlace(rail, station, {rail.in_station, across.in_station}).aside;
    const double beside = aside / across.aside;
    const double room = kAsideShare * rail.reach_mm / std::abs(across.aside);
    if (allowed.empty()) level = std::clamp(beside, across.range.low, across.range.high);
    allowed.push_back(spanInLimits({beside - room, beside + room}, across.range));
  }
  return ledThrough(stations, allowed, level);
}

}  // namespace lamina
