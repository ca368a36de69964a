// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/response_surrogates.hpp"

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/fitness.hpp"

namespace lamina {

ResponseSurrogates::ResponseSurrogates(const DesignSpace& space,
                                       const std::vector<std::string>& response_names,
                                       const std::vector<Evaluation>& samples, const SurrogateFit& fit) {
  const std::vector<Evaluation> unique = withoutReplicates(samples);
  for (std::size_t k = 0; k < response_names.size(); ++k) {
    std::vector<DesignPoint> points;
    std::vector<double> values;
    for (const Evaluation& sample : unique) {
      if (!std::isfinite(sample.responses.at(k))) continue;
      points.push_back(sample.point);
      values.push_back(sample.responses[k]);
    }
    try {
      surrogates_.push_back(fit(space, points, values));
    } catch (const InvalidInput& error) {
      throw InvalidInput("response " + response_names[k] + ": " + error.what());
    }
  }
}

std::vector<Prediction> ResponseSurrogates::at(const DesignPoint& point) const {
  std::vector<Prediction> predictions;
  predictions.reserve(surrogates_.size());
  for (const auto& surrogate : surrogates_) predictions.push_back(surrogate->at(point));
  return predictions;
}

std::vector<std::string> ResponseSurrogates::descriptions() const {
  std::vector<std::string> lines;
  lines.reserve(surrogates_.size());
  for (const auto& surrogate : surrogates_) lines.push_back(surrogate->description());
  return lines;
}

std::vector<Evaluation> withMissingPredicted(std::vector<Evaluation> samples,
                                             const ResponseSurrogates& surrogates) {
  for (Evaluation& sample : samples) {
    if (!isEvaluated(sample)) continue;
    const std::vector<Prediction> predictions = surrogates.at(sample.point);
    for (std::size_t k = 0; k < sample.responses.size(); ++k)
      if (!std::isfinite(sample.responses[k])) sample.responses[k] = predictions[k].value;
  }
  return samples;
}

}  // namespace lamina
