#include "widgets/capture/instruction_voice.h"

#include "widgets/capture/speaker.h"

namespace hexoderm {

InstructionVoice::InstructionVoice(Speaker* speaker, QObject* parent) : QObject(parent), speaker_(speaker) {
  speaker_->setParent(this);
  stands_.setSingleShot(true);
  stands_.setInterval(kStands_ms);
  connect(&stands_, &QTimer::timeout, this, &InstructionVoice::speak);
  connect(speaker_, &Speaker::lookedFor, this, &InstructionVoice::lookedFor);
}

void InstructionVoice::setEnabled(bool enabled) {
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

void InstructionVoice::setInstruction(const QString& instruction) {
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

void InstructionVoice::lookForVoice() { speaker_->lookForVoice(); }

void InstructionVoice::speak() {
  if (instruction_.isEmpty() || instruction_ == spoken_) return;
  spoken_ = instruction_;
  speaker_->say(spoken_);
  emit spoken(spoken_);
}

}  // namespace hexoderm
