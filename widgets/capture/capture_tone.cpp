#include "widgets/capture/capture_tone.h"

#include "hexoderm/base/units.h"

#include <QBuffer>
#include <QThread>
#include <QtEndian>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <vector>
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
#include <QAudioDevice>
#include <QAudioSink>
#include <QMediaDevices>
#else
#include <QAudioDeviceInfo>
#include <QAudioOutput>
#endif

namespace hexoderm {
namespace {

constexpr int kRate_hz = 44100;
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
using AudioOutput = QAudioSink;
#else
using AudioOutput = QAudioOutput;
#endif

struct Note {
  double frequency_hz = 0;  ///< 0: a pause
  double duration_s = 0;
};

std::vector<Note> notesOf(ToneKind kind) {
  if (kind == ToneKind::Captured) return {{880, 0.16}};
  return {{330, 0.09}, {0, 0.06}, {330, 0.09}};
}

QAudioFormat audioFormat() {
  QAudioFormat format;
  format.setSampleRate(kRate_hz);
  format.setChannelCount(1);
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  format.setSampleFormat(QAudioFormat::Int16);
#else
  format.setSampleSize(16);
  format.setSampleType(QAudioFormat::SignedInt);
  format.setByteOrder(QAudioFormat::LittleEndian);
  format.setCodec(QStringLiteral("audio/pcm"));
#endif
  return format;
}

/// Null without a device that takes the format.
std::unique_ptr<AudioOutput> openOutput() {
  const QAudioFormat format = audioFormat();
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  const QAudioDevice device = QMediaDevices::defaultAudioOutput();
#else
  const QAudioDeviceInfo device = QAudioDeviceInfo::defaultOutputDevice();
#endif
  if (device.isNull() || !device.isFormatSupported(format)) return nullptr;
  return std::make_unique<AudioOutput>(device, format);
}

}  // namespace

/// Lives on a thread of its own: looking for devices can wait for a sound server.
class CaptureTone::Player : public QObject {
 public:
  void play(ToneKind kind) {
    if (!is_opened_) {
      output_ = openOutput();
      is_opened_ = true;
      has_device = output_ != nullptr;
    }
    if (!output_) return;
    output_->stop();
    buffer_.close();
    buffer_.setData(toneSamples(kind, kRate_hz));
    buffer_.open(QIODevice::ReadOnly);
    output_->start(&buffer_);
  }

  std::atomic<bool> has_device = false;

 private:
  QBuffer buffer_{this};
  std::unique_ptr<AudioOutput> output_;
  bool is_opened_ = false;
};

QByteArray toneSamples(ToneKind kind, int rate_hz) {
  constexpr double kLoudness = 0.35;  // share of full scale
  constexpr double kFade_s = 0.012;   // so that no note begins or ends with a click
  std::vector<qint16> samples;
  for (const Note& note : notesOf(kind)) {
    const int count = static_cast<int>(std::lround(note.duration_s * rate_hz));
    for (int k = 0; k < count; ++k) {
      const double time_s = static_cast<double>(k) / rate_hz;
      const double fade = std::clamp(std::min(time_s, note.duration_s - time_s) / kFade_s, 0.0, 1.0);
      const double value = kLoudness * fade * std::sin(2 * kPi * note.frequency_hz * time_s);
      samples.push_back(qToLittleEndian(static_cast<qint16>(std::lround(32767 * value))));
    }
  }
  return {reinterpret_cast<const char*>(samples.data()), static_cast<int>(samples.size() * sizeof(qint16))};
}

CaptureTone::~CaptureTone() {
  constexpr unsigned long kPatience_ms = 500;
  if (thread_ == nullptr) return;
  thread_->quit();
  // A sound server that hangs must not keep the window from closing: its thread is then left to the end of the process.
  if (thread_->wait(kPatience_ms)) delete thread_;
}

bool CaptureTone::hasDevice() const { return player_ != nullptr && player_->has_device; }

void CaptureTone::play(ToneKind kind) {
  if (!enabled_) return;
  if (thread_ == nullptr) {
    thread_ = new QThread;
    player_ = new Player;
    player_->moveToThread(thread_);
    connect(thread_, &QThread::finished, player_, &QObject::deleteLater);
    thread_->start();
  }
  QMetaObject::invokeMethod(
      player_, [player = player_, kind] { player->play(kind); }, Qt::QueuedConnection);
  emit played(kind);
}

}  // namespace hexoderm
