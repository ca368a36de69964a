// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

/// The layer that fails, as errors name it: "layer 12 at 2.4 mm".
/// @param layer   index, from 0, as in `;LAYER:`
/// @param top_mm  where the nozzle's tip runs, in the frame of the layers
std::string layerPlace(std::size_t layer, double top_mm);

/// An island of it: "layer 12 at 2.4 mm, island 3".
/// @param island  index in its layer, from 0
std::string islandPlace(std::size_t layer, double top_mm, std::size_t island);

/// A path of it: "layer 12 at 2.4 mm, path 3".
/// @param path  index in its layer, from 0
std::string pathPlace(std::size_t layer, double top_mm, std::size_t path);

/// Throws the error that a failure stands for: the kind of its code, with its message. A failure without
/// error, `Ok`, is Internal.
[[noreturn]] void throwFailure(const Failure& failure);

/// An error that carries more than its message.
class RichError {
 public:
  virtual ~RichError() = default;

  /// Throws the same error, with all it carries, and the place in front of its message.
  [[noreturn]] virtual void throwAt(const std::string& place) const = 0;
};

/// Throws the exception being handled again with the place in front of its message: "layer 12 at 2.4 mm:
/// ...". Its code stays, and what a `RichError` carries besides. `Cancelled` stays as it is; what is no
/// `Error` becomes Internal. Call inside a catch block only.
[[noreturn]] void rethrowAt(const std::string& place);

}  // namespace lamina
