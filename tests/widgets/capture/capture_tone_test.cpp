#include "widgets/capture/capture_tone.h"

#include <gtest/gtest.h>
#include <QtWidgets>
#include <cstdlib>
#include <vector>

namespace hexoderm {
namespace {

constexpr int kRate_hz = 44100;

std::vector<int> samplesOf(ToneKind kind) {
  const QByteArray bytes = toneSamples(kind, kRate_hz);
  std::vector<int> samples;
  for (int k = 0; k + 1 < bytes.size(); k += 2) samples.push_back(qFromLittleEndian<qint16>(bytes.constData() + k));
  return samples;
}

/// Frequency of the first note, which ends with silence of 10 ms.
double frequencyOf(const std::vector<int>& samples) {
  int crossings = 0;
  std::size_t last = 0;
  for (std::size_t k = 1; k < samples.size() && k - last < kRate_hz / 100; ++k) {
    if (samples[k - 1] < 0 && samples[k] >= 0) {
      ++crossings;
      last = k;
    }
  }
  return 1.0 * crossings * kRate_hz / static_cast<double>(last);
}

TEST(CaptureTone, TheToneOfACaptureIsHigherAndSingleTheOtherLowerAndDouble) {
  const std::vector<int> captured = samplesOf(ToneKind::Captured);
  const std::vector<int> over = samplesOf(ToneKind::StartsOver);
  EXPECT_NEAR(frequencyOf(captured), 880, 20);
  EXPECT_NEAR(frequencyOf(over), 330, 20);
  EXPECT_EQ(over[over.size() / 2], 0) << "a pause between its two notes";
  EXPECT_LT(captured.size(), kRate_hz / 2U) << "short";
}

TEST(CaptureTone, NeitherClicksNorClips) {
  for (const ToneKind kind : {ToneKind::Captured, ToneKind::StartsOver}) {
    const std::vector<int> samples = samplesOf(kind);
    EXPECT_EQ(samples.front(), 0);
    EXPECT_LT(std::abs(samples.back()), 200);
    int largest = 0;
    for (const int sample : samples) largest = std::max(largest, std::abs(sample));
    EXPECT_LT(largest, 32767 / 2);
    EXPECT_GT(largest, 32767 / 5);
  }
}

TEST(CaptureTone, WithoutADeviceItIsSilentAndSwitchedOffItNeverLooksForOne) {
  CaptureTone tone;
  std::vector<ToneKind> played;
  QObject::connect(&tone, &CaptureTone::played, [&](ToneKind kind) { played.push_back(kind); });
  EXPECT_TRUE(tone.isEnabled());
  tone.playStartsOver();
  EXPECT_EQ(played, std::vector{ToneKind::StartsOver});
  CaptureTone silent;
  QObject::connect(&silent, &CaptureTone::played, [&](ToneKind kind) { played.push_back(kind); });
  silent.setEnabled(false);
  silent.playCaptured();
  EXPECT_FALSE(silent.hasDevice());
  EXPECT_EQ(played.size(), 1U);
}

}  // namespace
}  // namespace hexoderm
