#pragma once

#include <QLocale>
#include <QObject>
#include <QString>

namespace hexoderm {

/// Speaks sentences aloud, one at a time: a new one ends the one before, and nothing waits in a queue. Never blocks.
class Speaker : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Looks whether there is a voice, if that is not known yet; lookedFor() follows.
  virtual void lookForVoice() = 0;
  virtual void say(const QString& sentence) = 0;
  virtual void stop() = 0;

 signals:
  /// `why_not`: one sentence for people if nothing can be spoken; empty: it can.
  void lookedFor(const QString& why_not);
};

/// The system's voice for a language (Qt's TextToSpeech), on a thread of its own. Where the program was built without
/// it, and where the system has no engine or no voice for the language, it says why and stays silent.
Speaker* makeSystemSpeaker(const QLocale& locale, QObject* parent);

}  // namespace hexoderm
