// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// How responses of two points are related by their distance. All are 1 at distance 0; ranges are in standard
/// deviations of the variables of the samples.
enum class Correlation {
  Exponential,         ///< exp(-sum |d|/range), a product over variables: continuous, not smooth
  SquaredExponential,  ///< exp(-r²/2) with r² = sum (d/range)²: smooth without bounds
  Matern32,            ///< (1 + √3 r) exp(-√3 r): once differentiable
  Matern52,            ///< (1 + √5 r + 5r²/3) exp(-√5 r): twice differentiable
};

/// Where ranges come from: greatest likelihood, within 0.02 to 10 deviations, or the settings.
enum class CorrelationRange { Fitted, Fixed };

/// Kriging: a polynomial and what is left of the samples, interpolated.
struct KrigingSettings {
  Correlation correlation = Correlation::Matern52;
  int regression_order = 2;  ///< 1 or 0 if the samples do not determine so many coefficients
  CorrelationRange range = CorrelationRange::Fitted;
  double fixed_range = 1.0;  ///< of every variable, in its standard deviations
};

/// Adds the keys kriging.*.
void describe(SettingsSchema& schema, KrigingSettings& settings);

/// Universal kriging by OpenTURNS. It interpolates: at a sample it gives the sample, with variance 0.
/// Replicates are one sample at their mean. Variables and response are standardised by mean and standard
/// deviation of the samples. A Categorical variable of more than two choices becomes one indicator variable
/// for each. A variable that no sample changes has no influence. Where samples lie on the polynomial, or
/// their likelihood has no greatest value that could be found, ranges are the fixed one.
SurrogateFit krigingFit(const KrigingSettings& settings);

/// The same by the defaults and keys kriging.* as text.
/// @throws InvalidConfig naming key, value and bound
SurrogateFit krigingFit(const std::vector<SettingText>& settings);

}  // namespace lamina
