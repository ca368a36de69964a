// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// How responses of two points are related by their distance. All are 1 at distance 0; ranges are in standard
/// deviations of the variables of the samples.
enum class Correlation {
  Exponential,         ///< product over variables of exp(-|d|/range): not smooth
  SquaredExponential,  ///< product of exp(-(d/range)²/2): smooth without bounds
  Matern32,            ///< once differentiable
  Matern52,            ///< twice differentiable
};

/// Where ranges come from.
enum class CorrelationRange { Fitted, Fixed };

/// Kriging: a polynomial and what is left of the samples, interpolated.
struct KrigingSettings {
  Correlation correlation = Correlation::Exponential;
  int regression_order = 2;  ///< 1 or 0 if the samples do not determine so many coefficients
  CorrelationRange range = CorrelationRange::Fitted;
  double fixed_range = 1.0;  ///< of every variable, in its standard deviations
};

/// Adds the keys kriging.*.
void describe(SettingsSchema& schema, KrigingSettings& settings);

/// Universal kriging by OpenTURNS. It interpolates: at a sample it gives the sample, with variance 0.
/// Replicates are one sample at their mean. Variables and response are standardised by mean and standard
/// deviation of the samples. A Categorical variable of more than two choices becomes one indicator variable
/// for each. A variable that no sample changes has no influence.
SurrogateFit krigingFit(const KrigingSettings& settings);

/// The same by the defaults and keys kriging.* as text.
/// @throws InvalidConfig naming key, value and bound
SurrogateFit krigingFit(const std::vector<SettingText>& settings);

}  // namespace lamina
