// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDateTime>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "drawing/background_reader.hpp"
#include "incline/incline_client.hpp"
#include "incline/incline_form.hpp"
#include "incline/part_view.hpp"

namespace lamina {

class FormWidget;
class LayerSlider;
class RunStrip;

/// All of the panel, in any window: the form, the run, and the parts it shows. ROS must have been started.
class PanelContent : public QWidget {
 public:
  /// @param action  of the node that inclines
  PanelContent(QWidget* parent, const std::string& action);
  ~PanelContent() override;

  InclineForm form() const;
  /// Shows a form that was saved (`textsOf`), or reports why it cannot.
  void load(const std::vector<SettingText>& texts);

  std::function<void()> changed;               ///< the form
  std::function<void(const Box3& box)> shown;  ///< parts that stand elsewhere than before [mm, bed frame]

 private:
  void run();
  void end(const RunOutcome& outcome);
  void drawSource(const std::string& path);
  void drawInclined(const std::string& path);
  void notifyShown();

  FormWidget* form_;
  RunStrip* strip_;
  LayerSlider* slider_;
  QDateTime drawn_source_time_;  ///< when the source that is drawn was written
  InclineClient client_;
  PartView view_;
  BackgroundReader source_reader_;
  BackgroundReader inclined_reader_;
  QTimer poll_;
};

}  // namespace lamina
