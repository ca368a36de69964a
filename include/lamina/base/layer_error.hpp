// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

/// The text by which errors name a layer: "layer 12 at 2.4 mm".
/// @param layer   index from 0, as in the G-code comment `;LAYER:`
/// @param top_mm  height at which the nozzle tip runs, in the frame of the layers
std::string layerPlace(std::size_t layer, double top_mm);

/// The text by which errors name an island of a layer: "layer 12 at 2.4 mm, island 3".
/// @param island  index in its layer, from 0
std::string islandPlace(std::size_t layer, double top_mm, std::size_t island);

/// The text by which errors name a path of a layer: "layer 12 at 2.4 mm, path 3".
/// @param path  index in its layer, from 0
std::string pathPlace(std::size_t layer, double top_mm, std::size_t path);

/// Throws a failure as the error class of its code, with its message. The code `Ok`, which is no error,
/// becomes Internal.
[[noreturn]] void throwFailure(const Failure& failure);

/// An error that carries values besides its code and message.
class RichError {
 public:
  virtual ~RichError() = default;

  /// Throws a copy of this error, with all that it carries, whose message begins with the place.
  [[noreturn]] virtual void throwAt(const std::string& place) const = 0;
};

/// Rethrows the exception that is being handled, its message preceded by the place: "layer 12 at 2.4 mm:
/// ...". Its code stays, and so does what a `RichError` carries. `Cancelled` stays as it is; an exception
/// that is not an `Error` becomes Internal. Call it only inside a catch block.
[[noreturn]] void rethrowAt(const std::string& place);

}  // namespace lamina
