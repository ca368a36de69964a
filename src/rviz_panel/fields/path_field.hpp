// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>

class QLineEdit;

namespace lamina {

/// A path with a button that opens a file dialog.
class PathField : public QWidget {
 public:
  enum class Mode { Open, Save };
  /// @param name    of the edit field for those who look for it; the button is <name>_browse
  /// @param filter  of the dialog: "Programs (*.gcode);;All files (*)"
  PathField(const QString& name, Mode mode, QString filter, QWidget* parent);

  QString path() const;
  void setPath(const QString& path);
  void setHint(const QString& text);

  std::function<void()> chosen;  ///< a path was entered, or chosen in the dialog
  std::function<void()> edited;  ///< the text changes

 private:
  void browse(Mode mode);

  QString filter_;
  QLineEdit* edit_;
};

}  // namespace lamina
