#include "app/window/settings/preferences.h"

#include "app/window/files/session_paths.h"
#include "app/window/settings/translation.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/units.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QFont>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

const QString kLanguage = QStringLiteral("view/language");
const QString kTextFactor = QStringLiteral("view/text_factor");
const QString kReducedMotion = QStringLiteral("view/reduced_motion");
const QString kSoftwareOpenGl = QStringLiteral("view/software_opengl");
const QString kTheme = QStringLiteral("view/theme");
const QString kTone = QStringLiteral("capture/tone");
const QString kSpeech = QStringLiteral("capture/speech");
const QString kDrift = QStringLiteral("capture/drift_limit_deg_s");
const QString kExcess = QStringLiteral("capture/excess_limit_mg");
const QString kHold = QStringLiteral("capture/hold_s");
const QString kSamples = QStringLiteral("capture/samples_per_cell");
const QString kFolder = QStringLiteral("paths/sessions");
const QString kLastFolder = QStringLiteral("paths/last");
const QString kThreshold = QStringLiteral("solver/class_threshold");

/// "solver/gap_model" of gap-model.
QString keyOf(const SolverChoice& choice) {
  const QString name = QString::fromUtf8(choice.name.data(), static_cast<int>(choice.name.size()));
  return QStringLiteral("solver/") + QString(name).replace(QLatin1Char('-'), QLatin1Char('_'));
}

void readNumber(const QString& key, double& value, double unit = 1) {
  bool is_number = false;
  const double read = QSettings().value(key).toDouble(&is_number);
  if (is_number && std::isfinite(read)) value = read * unit;
}

}  // namespace

Preferences::Preferences(QObject* parent) : QObject(parent) {}

QString Preferences::language() const {
  const QString language = QSettings().value(kLanguage).toString();
  return isLanguageChoice(language) ? language : QLatin1String(kSystemLanguage);
}

void Preferences::setLanguage(const QString& language) { QSettings().setValue(kLanguage, language); }

ThemeChoice Preferences::theme() const {
  return themeChoiceFromName(QSettings().value(kTheme).toString()).value_or(ThemeChoice::System);
}

void Preferences::setTheme(ThemeChoice choice) { QSettings().setValue(kTheme, themeChoiceName(choice)); }

double Preferences::textFactor() const {
  double factor = 1;
  readNumber(kTextFactor, factor);
  return std::clamp(factor, 0.8, 2.0);
}

void Preferences::setTextFactor(double factor) {
  if (factor == textFactor()) return;
  QSettings().setValue(kTextFactor, factor);
  emit textFactorChanged(textFactor());
}

bool Preferences::tone() const { return QSettings().value(kTone, true).toBool(); }

void Preferences::setTone(bool on) {
  if (on == tone()) return;
  QSettings().setValue(kTone, on);
  emit toneChanged(on);
}

bool Preferences::speech() const { return QSettings().value(kSpeech, false).toBool(); }

void Preferences::setSpeech(bool on) {
  if (on == speech()) return;
  QSettings().setValue(kSpeech, on);
  emit speechChanged(on);
}

bool Preferences::reducedMotion() const { return QSettings().value(kReducedMotion, false).toBool(); }

void Preferences::setReducedMotion(bool on) {
  if (on == reducedMotion()) return;
  QSettings().setValue(kReducedMotion, on);
  emit reducedMotionChanged(on);
}

bool Preferences::softwareOpenGl() const { return QSettings().value(kSoftwareOpenGl, false).toBool(); }

void Preferences::setSoftwareOpenGl(bool on) { QSettings().setValue(kSoftwareOpenGl, on); }

QString Preferences::sessionFolder() const { return QSettings().value(kFolder).toString(); }

void Preferences::setSessionFolder(const QString& folder) { QSettings().setValue(kFolder, folder); }

SolverOptions Preferences::solverOptions() const {
  SolverOptions options;
  for (const SolverChoice& choice : solverChoices()) {
    const QString value = QSettings().value(keyOf(choice)).toString();
    if (value.isEmpty()) continue;
    try {
      choice.set(options, value.toStdString());
    } catch (const InvalidArgument&) {
      continue;  // it is no name: the default stays
    }
  }
  readNumber(kThreshold, options.class_threshold);
  try {
    options.validate();
  } catch (const InvalidArgument&) {
    return {};
  }
  return options;
}

void Preferences::setSolverOptions(const SolverOptions& options) {
  if (options == solverOptions()) return;
  for (const SolverChoice& choice : solverChoices()) {
    const std::string_view value = choice.get(options);
    QSettings().setValue(keyOf(choice), QString::fromUtf8(value.data(), static_cast<int>(value.size())));
  }
  QSettings().setValue(kThreshold, options.class_threshold);
  emit solverOptionsChanged(solverOptions());
}

PoseRecorderOptions Preferences::recorderOptions() const {
  PoseRecorderOptions options;
  readNumber(kDrift, options.stillness.drift_limit_rad_s, kDegree);
  readNumber(kExcess, options.stillness.excess_limit_g, kMilliG);
  readNumber(kHold, options.stillness.hold_s);
  options.samples_per_cell = QSettings().value(kSamples, options.samples_per_cell).toUInt();
  options.stillness.drift_window_s = std::max(options.stillness.drift_window_s, options.stillness.hold_s);
  try {
    options.validate();
  } catch (const InvalidArgument&) {
    return {};
  }
  return options;
}

void Preferences::setRecorderOptions(const PoseRecorderOptions& options) {
  const PoseRecorderOptions before = recorderOptions();
  // Rounded, so that what was typed is what is kept.
  const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6; };
  QSettings settings;
  settings.setValue(kDrift, rounded(options.stillness.drift_limit_rad_s / kDegree));
  settings.setValue(kExcess, rounded(options.stillness.excess_limit_g / kMilliG));
  settings.setValue(kHold, rounded(options.stillness.hold_s));
  settings.setValue(kSamples, options.samples_per_cell);
  const PoseRecorderOptions now = recorderOptions();
  if (now.stillness.drift_limit_rad_s != before.stillness.drift_limit_rad_s ||
      now.stillness.excess_limit_g != before.stillness.excess_limit_g ||
      now.stillness.hold_s != before.stillness.hold_s || now.samples_per_cell != before.samples_per_cell) {
    emit recorderOptionsChanged(now);
  }
}

void Preferences::restoreDefaults() {
  const bool tone_before = tone();
  const bool motion_before = reducedMotion();
  setSpeech(false);
  QSettings settings;
  for (const QString& key : {kLanguage, kSoftwareOpenGl, kTheme, kFolder, kTone, kSpeech, kReducedMotion}) {
    settings.remove(key);
  }
  setTextFactor(1);
  setSolverOptions({});
  setRecorderOptions({});
  if (tone() != tone_before) emit toneChanged(tone());
  if (reducedMotion() != motion_before) emit reducedMotionChanged(reducedMotion());
  emit restored();
}

QString lastFolder() {
  const QString folder = QSettings().value(kLastFolder).toString();
  if (!folder.isEmpty() && QDir(folder).exists()) return folder;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QDir(documents).exists() ? documents : QDir::homePath();
}

void rememberFolder(const QString& file) {
  if (file.isEmpty() || isInUnsavedFolder(file)) return;
  QSettings().setValue(kLastFolder, QFileInfo(file).absolutePath());
}

void applyTextFactor(double factor) {
  // The system's, as it was before the first factor.
  static const QFont kSystem = QApplication::font();
  QFont font = kSystem;
  if (font.pointSizeF() > 0) {
    font.setPointSizeF(std::round(font.pointSizeF() * factor * 10) / 10);
  } else {
    font.setPixelSize(static_cast<int>(std::lround(font.pixelSize() * factor)));
  }
  // Without ligatures, which take long to look for. Scripts that need shaping are still shaped.
  font.setStyleStrategy(QFont::PreferNoShaping);
  QApplication::setFont(font);
}

bool prepareSoftwareOpenGl(bool asked) {
  if (!asked && !QSettings().value(kSoftwareOpenGl, false).toBool()) return false;
  qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
  // It would send all drawing to the display's server, which knows no OpenGL that is new enough.
  qunsetenv("LIBGL_ALWAYS_INDIRECT");
  qputenv("QT_OPENGL", "software");
  QCoreApplication::setAttribute(Qt::AA_UseSoftwareOpenGL);
  return true;
}

}  // namespace hexoderm
