// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"

namespace lamina {

/// What a surrogate expects of a response, and how far it may be wrong: the square of the standard deviation.
struct Prediction {
  double value = 0.0;
  double variance = 0.0;
};

/// One response as a function of the design, learnt from samples of it. Asked from one thread at a time.
class Surrogate {
 public:
  virtual ~Surrogate() = default;

  /// @param point  of the space it was fitted in; integer variables and levels may take values in between
  virtual Prediction at(const DesignPoint& point) const = 0;

  /// The value of the prediction alone, which may be cheaper.
  virtual double valueAt(const DesignPoint& point) const { return at(point).value; }

  /// One line for a report: the kind of surrogate and what was fitted, such as regression and correlation
  /// lengths.
  virtual std::string description() const = 0;
};

/// Fits a surrogate to samples: points of the space, and a value at each. Searches learn through such a
/// function; they call it from one thread at a time. Throws InvalidInput if there are too few samples, or a
/// value is not finite. Several samples at one point are replicates.
using SurrogateFit = std::function<std::unique_ptr<Surrogate>(
    const DesignSpace&, const std::vector<DesignPoint>&, const std::vector<double>& values)>;

}  // namespace lamina
