// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// Correlation of the responses at two points, by their distance d in each variable. All correlations are 1
/// at distance 0; ranges are in standard deviations of the variables over the samples.
enum class Correlation {
  Exponential,         ///< exp(-sum |d|/range), a product over variables: continuous, not smooth
  SquaredExponential,  ///< exp(-r²/2) with r² = sum (d/range)²: smooth without bounds
  Matern32,            ///< (1 + √3 r) exp(-√3 r): once differentiable
  Matern52,            ///< (1 + √5 r + 5r²/3) exp(-√5 r): twice differentiable
};

/// How ranges are determined: by maximum likelihood, within 0.02 to 10 standard deviations, or as in the
/// settings.
enum class CorrelationRange { Fitted, Fixed };

/// Settings of kriging: a polynomial, plus an interpolation of the samples' residuals from it.
struct KrigingSettings {
  Correlation correlation = Correlation::Matern52;
  /// Of the polynomial: 0, 1 or 2; lowered if the samples do not determine that many coefficients.
  int regression_order = 2;
  CorrelationRange range = CorrelationRange::Fitted;
  double fixed_range = 1.0;  ///< for every variable, in its standard deviations
};

/// Adds the keys kriging.*.
void describe(SettingsSchema& schema, KrigingSettings& settings);

/// Universal kriging by OpenTURNS. It interpolates: at a sample it returns the sample, with variance 0.
/// Replicates count as one sample at their mean. Variables and response are standardised by mean and standard
/// deviation of the samples. A Categorical variable of more than two choices becomes one indicator variable
/// for each choice. A variable with the same value in all samples has no influence. If the samples lie on the
/// polynomial, or no maximum of their likelihood is found, `fixed_range` is used.
SurrogateFit krigingFit(const KrigingSettings& settings);

/// As above, with the default settings changed by keys kriging.* as text.
/// @throws InvalidConfig naming key, value and bound
SurrogateFit krigingFit(const std::vector<SettingText>& settings);

}  // namespace lamina
