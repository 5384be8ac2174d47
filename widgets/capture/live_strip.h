#pragma once

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "widgets/controls/banner.h"

#include <QFrame>

class QAction;
class QLabel;

namespace hexoderm {

/// "Streaming", "Silent", ...: one word for where a source stands (translated).
QString sourceStateWord(SourceState state);
/// A sign of its own for each state, so that no meaning hangs on hue.
QString sourceStateSign(SourceState state);
Tone sourceStateTone(SourceState state);
/// "17,230 frames · 0 lost · 0 late"; what else went wrong is added where there is any.
QString countersText(const SourceStatus& status, const HoldStatus& hold);

/// "12 samples lost · 3 frames late · 40 samples dropped by the device": what there is of that; empty: nothing.
QString lossesText(const SourceStatus& status, const HoldStatus& hold);

/// The strip for a skin that does not (yet) send as it should: the state of its source, and a button that disconnects
/// it. The window shows it over the content until all is well; then the status bar and the step Capture say more.
class LiveStrip : public QFrame {
  Q_OBJECT

 public:
  /// `end`: what the button does.
  explicit LiveStrip(QAction* end, QWidget* parent = nullptr);

  void setStatus(const SourceStatus& status, const HoldStatus& hold);

 private:
  QLabel* sign_;
  QLabel* word_;
  QLabel* text_;
  QLabel* counters_;
};

}  // namespace hexoderm
