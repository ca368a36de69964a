// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lamina/optimisation/evaluation.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// A surrogate for each response, fitted to the samples that have this response.
class ResponseSurrogates {
 public:
  /// @param samples  failed ones and missing responses are left out
  /// @throws InvalidInput naming the response if no surrogate can be fitted to it
  ResponseSurrogates(const DesignSpace& space, const std::vector<std::string>& response_names,
                     const std::vector<Evaluation>& samples, const SurrogateFit& fit);

  /// A prediction for each response.
  std::vector<Prediction> at(const DesignPoint& point) const;

  /// @param response  index
  const Surrogate& of(std::size_t response) const { return *surrogates_.at(response); }

  /// A line for each response.
  std::vector<std::string> descriptions() const;

 private:
  std::vector<std::unique_ptr<Surrogate>> surrogates_;
};

/// The samples with predictions in place of missing responses. Failed samples stay as they are.
std::vector<Evaluation> withMissingPredicted(std::vector<Evaluation> samples,
                                             const ResponseSurrogates& surrogates);

}  // namespace lamina
