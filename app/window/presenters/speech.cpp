#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide.h"

namespace hexoderm {

void connectSpeech(const WindowParts& parts) {
  QObject::connect(parts.views.capture_panel, &CapturePanel::instructionChanged, &parts.wires,
                   [&parts] { refreshSpeech(parts); });
  const auto follow = [&parts] { parts.views.voice->setEnabled(parts.preferences.isOn(Switch::Speech)); };
  follow();
  QObject::connect(&parts.preferences, &Preferences::switched, &parts.wires, follow);
}

void refreshSpeech(const WindowParts& parts) {
  const SessionController& controller = parts.controller;
  QString instruction;
  if (controller.liveSession().source().isRunning() && !controller.liveMode().isOn()) {
    if (!controller.liveSession().isRobotOn()) instruction = parts.views.capture_panel->instruction();
    if (instruction.isEmpty()) instruction = describeStand(controller, parts.actions).sentence;
  }
  parts.views.voice->setInstruction(instruction);
}

}  // namespace hexoderm
