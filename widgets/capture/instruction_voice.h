#pragma once

#include "widgets/capture/speaker.h"
#include "widgets/controls/panel_parts.h"

#include <QObject>
#include <QString>
#include <QTimer>

namespace hexoderm {

/// Speaks the instruction that stands, for whoever has hands and eyes on the part: when it has changed and stands for a
/// moment, once. What no longer stands is not spoken, nor spoken to its end. Off until it is switched on.
class InstructionVoice : public QObject {
  Q_OBJECT

 public:
  /// An instruction that changes sooner was only passed by.
  static constexpr int kStands_ms = 600;

  /// Takes over the speaker.
  explicit InstructionVoice(Speaker* speaker, QObject* parent = nullptr) : QObject(parent), speaker_(speaker) {
    speaker_->setParent(this);
    setUpOnce(stands_, kStands_ms, this, [this] { speak(); });
    connect(speaker_, &Speaker::lookedFor, this, &InstructionVoice::lookedFor);
  }

  /// Switched on, it speaks what stands.
  void setEnabled(bool enabled) {
    if (enabled_ == enabled) return;
    enabled_ = enabled;
    spoken_.clear();
    stands_.stop();
    if (!enabled_) {
      speaker_->stop();
    } else if (!instruction_.isEmpty()) {
      stands_.start();
    }
  }

  [[nodiscard]] bool isEnabled() const { return enabled_; }
  /// What stands now; empty: nothing. Cheap: may come 20 times a second.
  void setInstruction(const QString& instruction) {
    if (instruction_ == instruction) return;
    instruction_ = instruction;
    if (!enabled_) return;
    // What is being spoken is no longer true; what was passed by for a moment is not said again.
    if (!spoken_.isEmpty() && instruction_ != spoken_) speaker_->stop();
    if (instruction_.isEmpty()) {
      spoken_.clear();
      stands_.stop();
    } else {
      stands_.start();
    }
  }

  /// Looks for a voice; lookedFor() follows.
  void lookForVoice() { speaker_->lookForVoice(); }

 signals:
  /// `why_not`: empty if there is a voice.
  void lookedFor(const QString& why_not);
  /// A sentence was given to the speaker.
  void spoken(const QString& sentence);

 private:
  void speak() {
    if (instruction_.isEmpty() || instruction_ == spoken_) return;
    spoken_ = instruction_;
    speaker_->say(spoken_);
    emit spoken(spoken_);
  }

  Speaker* speaker_;
  QString instruction_;
  QString spoken_;  ///< last, unless something else stood since
  bool enabled_ = false;
  QTimer stands_;
};

}  // namespace hexoderm
