// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/web/cell_desk.hpp"
#include "messages.hpp"

namespace lamina {

/// The files of an uploaded mesh that is sliced, beside the upload: the mesh under a name with the suffix of
/// its format, and the program. Both are deleted with this object.
class SlicedUpload {
 public:
  /// @throws FileError if the mesh cannot be linked
  explicit SlicedUpload(const DeskMesh& mesh);
  ~SlicedUpload();
  SlicedUpload(const SlicedUpload&) = delete;
  SlicedUpload& operator=(const SlicedUpload&) = delete;

  /// The request to slice the mesh. Nothing is published: nodes that follow a print would mistake the
  /// toolpath for that of the print.
  lamina_msgs::SliceMesh request() const;
  /// The program to be queued.
  DeskProgram program() const;
  /// A message in which the paths of these files are replaced by the names that the sender knows.
  std::string withNames(std::string message) const;

 private:
  DeskMesh mesh_;
  std::string linked_;
  std::string program_;
};

}  // namespace lamina
