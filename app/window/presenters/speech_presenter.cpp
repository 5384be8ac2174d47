#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide.h"

namespace hexoderm {
namespace {

/// Has the instruction spoken that stands while a skin is connected, if the operator wants it: that of the step
/// Capture, or where there is none the sentence of the banner.
class SpeechPresenter : public Presenter {
 public:
  explicit SpeechPresenter(const WindowParts& parts) : Presenter(parts) {
    connect(views_.capture_panel, &CapturePanel::instructionChanged, this, &SpeechPresenter::refresh);
    const auto follow = [this] { views_.voice->setEnabled(preferences_.isOn(Switch::Speech)); };
    follow();
    connect(&preferences_, &Preferences::switched, this, follow);
  }

  void refresh() override { views_.voice->setInstruction(instruction()); }

 private:
  QString instruction() const {
    if (!controller_.liveSession().source().isRunning() || controller_.liveMode().isOn()) return {};
    const QString of_capture = controller_.poseGuide().isRobotOn() ? QString() : views_.capture_panel->instruction();
    return of_capture.isEmpty() ? describeStand(controller_, actions_).sentence : of_capture;
  }
};

}  // namespace

std::unique_ptr<Presenter> makeSpeechPresenter(const WindowParts& parts) {
  return std::make_unique<SpeechPresenter>(parts);
}

}  // namespace hexoderm
