#pragma once

#include <QObject>
#include <QString>

namespace hexoderm {

class CapturePanel;
class InstructionVoice;
class Preferences;
class PreferencesPresenter;
class SessionController;
class WindowActions;

/// Has the instruction spoken that stands while a skin is connected, if the operator wants it: that of the step
/// Capture, or where there is none the sentence of the banner.
class SpeechPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    CapturePanel& panel;
    InstructionVoice& voice;
  };
  /// All outlive the presenter.
  SpeechPresenter(const Views& views, const SessionController& controller, const WindowActions& actions,
                  const Preferences& preferences, const PreferencesPresenter& dialogs);

  void refresh();

 private:
  [[nodiscard]] QString instruction() const;

  Views views_;
  const SessionController& controller_;
  const WindowActions& actions_;
};

}  // namespace hexoderm
