#include "widgets/capture/speaker.h"

#include <QCoreApplication>
#include <QThread>
#include <memory>
#include <utility>
#ifdef HEXODERM_HAS_SPEECH
#include <QTextToSpeech>
#endif

namespace hexoderm {
namespace {

struct SpeakerWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::Speaker)
};

#ifdef HEXODERM_HAS_SPEECH

/// Lives on a thread of its own: an engine may have to start a server first.
class Engine final : public Speaker {
 public:
  /// "C" is nobody's language; texts are English then.
  explicit Engine(const QLocale& locale)
      : locale_(locale.language() == QLocale::C ? QLocale(QLocale::English) : locale) {}

  void lookForVoice() override { emit lookedFor(open()); }
  void say(const QString& sentence) override {
    if (!open().isEmpty()) return;
    speech_->stop();
    speech_->say(sentence);
  }
  void stop() override {
    if (speech_) speech_->stop();
  }

 private:
  /// Empty if it can speak.
  QString open() {
    if (!speech_ && !QTextToSpeech::availableEngines().isEmpty()) speech_ = std::make_unique<QTextToSpeech>();
    if (!speech_ || speech_->state() == QTextToSpeech::BackendError) {
      speech_.reset();  // perhaps there is one the next time
      return SpeakerWords::tr("This computer has no engine that speaks, or none that answers.");
    }
    for (const QLocale& known : speech_->availableLocales()) {
      if (known.language() != locale_.language()) continue;
      speech_->setLocale(known);
      return {};
    }
    return SpeakerWords::tr("This computer's engine has no voice for %1.")
        .arg(QLocale::languageToString(locale_.language()));
  }

  QLocale locale_;
  std::unique_ptr<QTextToSpeech> speech_;
};

class SystemSpeaker final : public Speaker {
 public:
  SystemSpeaker(const QLocale& locale, QObject* parent)
      : Speaker(parent), thread_(new QThread), engine_(new Engine(locale)) {
    engine_->moveToThread(thread_);
    connect(thread_, &QThread::finished, engine_, &QObject::deleteLater);
    connect(engine_, &Speaker::lookedFor, this, &Speaker::lookedFor);
  }
  ~SystemSpeaker() override {
    constexpr unsigned long kPatience_ms = 500;
    if (!thread_->isRunning()) {
      delete engine_;
      delete thread_;
      return;
    }
    thread_->quit();
    // An engine that hangs must not keep the window from closing: its thread is then left to the end of the process.
    if (thread_->wait(kPatience_ms)) delete thread_;
  }

  void lookForVoice() override {
    onThread([engine = engine_] { engine->lookForVoice(); });
  }
  void say(const QString& sentence) override {
    onThread([engine = engine_, sentence] { engine->say(sentence); });
  }
  void stop() override {
    if (thread_->isRunning()) onThread([engine = engine_] { engine->stop(); });
  }

 private:
  template <class Work>
  void onThread(Work work) {
    if (!thread_->isRunning()) thread_->start();
    QMetaObject::invokeMethod(engine_, std::move(work), Qt::QueuedConnection);
  }

  QThread* thread_;
  Engine* engine_;
};

#else

class SystemSpeaker final : public Speaker {
 public:
  SystemSpeaker(const QLocale& /*locale*/, QObject* parent) : Speaker(parent) {}
  void lookForVoice() override { emit lookedFor(SpeakerWords::tr("This program was built without speech.")); }
  void say(const QString& /*sentence*/) override {}
  void stop() override {}
};

#endif

}  // namespace

Speaker* makeSystemSpeaker(const QLocale& locale, QObject* parent) { return new SystemSpeaker(locale, parent); }

}  // namespace hexoderm
