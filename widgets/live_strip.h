#pragma once

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "widgets/banner.h"

#include <QFrame>

class QAction;
class QCheckBox;
class QLabel;
class QProgressBar;

namespace hexoderm {

/// "Streaming", "Silent", ...: one word for where a source stands (translated).
QString sourceStateWord(SourceState state);
/// A sign of its own for each state, so that no meaning hangs on hue.
QString sourceStateSign(SourceState state);
Tone sourceStateTone(SourceState state);
/// "17,230 frames · 0 lost · 0 late"; what is broken is added where there is any.
QString countersInWords(const SourceStatus& status, const HoldStatus& hold);

/// A skin that is connected: where its source stands, whether the part is still and what moves, and what can be done
/// about it. Always in view while there is a source.
class LiveStrip : public QFrame {
  Q_OBJECT

 public:
  /// `automatic` can be checked.
  LiveStrip(QAction* automatic, QAction* capture, QAction* end, QWidget* parent = nullptr);

  /// `is_capturing`: poses are taken, so that stillness is shown.
  void setStatus(const SourceStatus& status, const HoldStatus& hold, bool is_capturing);
  void setTheme(Theme theme);

 private:
  void paintSign();

  QLabel* sign_;
  QLabel* word_;
  QLabel* text_;
  QLabel* counters_;
  QWidget* capture_row_;
  QProgressBar* progress_;
  QLabel* hold_;
  QCheckBox* automatic_;
  SourceState state_ = SourceState::Stopped;
  Theme theme_ = Theme::Light;
};

}  // namespace hexoderm
