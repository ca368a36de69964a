// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/taut_string.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>

namespace lamina {

namespace {

struct Knot {
  std::size_t gate = 0;
  double at = 0.0;
  double value = 0.0;
};

double slope(const Knot& from, const Knot& to) { return (to.value - from.value) / (to.at - from.at); }

/// A string pulled gate by gate: from the last knot that is certain two chains lead on, the shortest ways to
/// the high and to the low end of the newest gate. They bend about high and low ends only.
class StringPulling {
 public:
  explicit StringPulling(const Knot& start) : knots_{start} {}

  void addHigh(const Knot& knot) { add(knot, high_, low_, 1.0); }
  void addLow(const Knot& knot) { add(knot, low_, high_, -1.0); }

  std::vector<Knot> finish() {
    knots_.insert(knots_.end(), high_.begin(), high_.end());
    return std::move(knots_);
  }

 private:
  /// @param sign  1 for the chain of high ends, whose slopes grow, -1 for that of low ends
  void add(const Knot& knot, std::deque<Knot>& own, std::deque<Knot>& other, double sign) {
    const auto before = [&] { return own.size() > 1 ? own[own.size() - 2] : knots_.back(); };
    while (!own.empty() && sign * slope(own.back(), knot) <= sign * slope(before(), own.back()))
      own.pop_back();
    while (own.empty() && !other.empty() &&
           sign * slope(knots_.back(), knot) < sign * slope(knots_.back(), other.front())) {
      knots_.push_back(other.front());
      other.pop_front();
    }
    own.push_back(knot);
  }

  std::vector<Knot> knots_;
  std::deque<Knot> high_;
  std::deque<Knot> low_;
};

}  // namespace

std::vector<double> tautString(const std::vector<Gate>& gates) {
  if (gates.empty()) return {};
  StringPulling pulling({0, gates[0].at, gates[0].low});
  for (std::size_t i = 1; i < gates.size(); ++i) {
    if (std::isfinite(gates[i].high)) pulling.addHigh({i, gates[i].at, gates[i].high});
    if (std::isfinite(gates[i].low)) pulling.addLow({i, gates[i].at, gates[i].low});
  }
  const std::vector<Knot> knots = pulling.finish();
  std::vector<double> values(gates.size(), gates[0].low);
  for (std::size_t k = 1; k < knots.size(); ++k)
    for (std::size_t i = knots[k - 1].gate + 1; i <= knots[k].gate; ++i) {
      const double along = (gates[i].at - knots[k - 1].at) / (knots[k].at - knots[k - 1].at);
      values[i] = knots[k - 1].value + along * (knots[k].value - knots[k - 1].value);
    }
  return values;
}

}  // namespace lamina
