// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/web/cell_desk.hpp"
#include "messages.hpp"

namespace lamina {

/// The files of an uploaded mesh that is sliced, beside the upload: the mesh under a name with its suffix, by
/// which its format is known, and the program. Both are deleted with this object.
class SlicedUpload {
 public:
  /// @throws FileError if the mesh cannot be linked
  explicit SlicedUpload(const DeskMesh& mesh);
  ~SlicedUpload();
  SlicedUpload(const SlicedUpload&) = delete;
  SlicedUpload& operator=(const SlicedUpload&) = delete;

  /// The request to slice it. Nothing is published: nodes that follow a print would take the toolpath for
  /// that of the print.
  lamina_msgs::SliceMesh request() const;
  /// The program to be queued.
  DeskProgram program() const;
  /// A message with the names that the sender knows in place of the paths of these files.
  std::string withNames(std::string message) const;

 private:
  DeskMesh mesh_;
  std::string linked_;
  std::string program_;
};

}  // namespace lamina
