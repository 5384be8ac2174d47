#include "app/window/settings/translation.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

/// The texts that have a German one, each with its context in front.
QSet<QString> germanTexts() {
  QFile file(HEXODERM_TRANSLATIONS "/hexoderm_de.ts");
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
  QSet<QString> texts;
  QString context;
  for (QXmlStreamReader xml(&file); !xml.atEnd(); xml.readNext()) {
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) texts << context + ": " + xml.readElementText();
  }
  EXPECT_GT(texts.size(), 300);
  return texts;
}

/// Asked first, and translates nothing: notes what is shown to people and has no German.
class MissingTexts : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char* /*comment*/, int /*count*/) const override {
    const QString key = QString::fromUtf8(context) + ": " + QString::fromUtf8(text);
    const bool is_ours = key.startsWith("hexoderm::");
    if (is_ours && !known_.contains(key) && !known_.contains("hexoderm: " + QString::fromUtf8(text))) missing_ << key;
    return {};
  }
  [[nodiscard]] QStringList missing() const { return missing_.values(); }

 private:
  const QSet<QString> known_ = germanTexts();
  mutable QSet<QString> missing_;
};

class GermanWindow : public WindowTest {
 protected:
  void SetUp() override {
    installTranslations(*qApp, "de");
    QCoreApplication::installTranslator(&missing_);
    WindowTest::SetUp();
  }
  void TearDown() override {
    QCoreApplication::removeTranslator(&missing_);
    window_.reset();
    installTranslations(*qApp, "en");
  }
  MissingTexts missing_;
};

TEST_F(GermanWindow, ShowsNoTextThatHasNoGerman) {
  takeDemoPoses(3);
  action("actionKeys")->trigger();
  waitForDialog("keysDialog");
  for (const QString& text : missing_.missing()) ADD_FAILURE() << text.toStdString();
  EXPECT_EQ(action("actionDemo")->iconText(), "Demo-Haut starten");
}

TEST(Translation, TheSystemsLanguageIsTakenWhereItIsShipped) {
  const auto help_in = [](const char* locale, const QStringList& arguments) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LC_ALL", QString::fromLatin1(locale));
    environment.remove("LANGUAGE");
    program.setProcessEnvironment(environment);
    program.start(HEXODERM_PROGRAM, arguments + QStringList{"--help"});
    EXPECT_TRUE(program.waitForFinished(test::kPatience_ms));
    return QString::fromUtf8(program.readAllStandardOutput());
  };
  const QString english = "A session or calibration to open.";
  const QString german = "Eine Sitzung oder Kalibrierung zum Öffnen.";
  EXPECT_TRUE(help_in("C.UTF-8", {}).contains(english));
  EXPECT_TRUE(help_in("de_DE.UTF-8", {}).contains(german));
  EXPECT_TRUE(help_in("fi_FI.UTF-8", {}).contains(english));
  EXPECT_TRUE(help_in("de_DE.UTF-8", {"--language=en"}).contains(english));
  EXPECT_TRUE(help_in("C.UTF-8", {"--language", "de"}).contains(german));
}

TEST(Translation, ALanguageBringsItsNumbers) {
  installTranslations(*qApp, "de");
  EXPECT_EQ(QLocale().toString(1.5), "1,5");
  installTranslations(*qApp, "en");
  EXPECT_EQ(QLocale().toString(1.5), "1.5");
}

}  // namespace
}  // namespace hexoderm
