#include "app/window/settings/translation.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

QApplication& application() { return *qobject_cast<QApplication*>(QCoreApplication::instance()); }

struct CatalogEntry {
  QString context;
  QString source;
  QString translation;
  bool is_unfinished = false;
};

std::vector<CatalogEntry> messagesOf(const QString& language) {
  QFile file(QStringLiteral(HEXODERM_TRANSLATIONS "/hexoderm_%1.ts").arg(language));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
  std::vector<CatalogEntry> messages;
  QXmlStreamReader xml(&file);
  CatalogEntry message;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) message.context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) message.source = xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      message.is_unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
      message.translation = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
      messages.push_back(message);
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

QStringList placeholdersOf(const QString& text) {
  static const QRegularExpression placeholder("%[1-9]");
  QStringList found;
  for (auto it = placeholder.globalMatch(text); it.hasNext();) found << it.next().captured();
  found.removeDuplicates();
  found.sort();
  return found;
}

TEST(Translation, TheShippedGermanIsComplete) {
  const std::vector<CatalogEntry> messages = messagesOf("de");
  EXPECT_GT(messages.size(), 300U);
  for (const CatalogEntry& message : messages) {
    const std::string text = message.context.toStdString() + ": " + message.source.toStdString();
    EXPECT_FALSE(message.is_unfinished) << text;
    EXPECT_FALSE(message.translation.isEmpty()) << text;
    EXPECT_EQ(placeholdersOf(message.translation), placeholdersOf(message.source)) << text;
    // A key in the source is one in the translation, and the dots that announce a dialog stay.
    EXPECT_EQ(message.translation.count(QLatin1Char('&')), message.source.count(QLatin1Char('&'))) << text;
    EXPECT_EQ(message.translation.endsWith(QChar(0x2026)), message.source.endsWith(QChar(0x2026))) << text;
  }
}

/// Asked first, and translates nothing: notes what is shown to people and has no German.
class MissingTexts : public QTranslator {
 public:
  MissingTexts() {
    for (const CatalogEntry& message : messagesOf("de")) known_.insert(keyOf(message.context, message.source));
  }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char* /*comment*/, int /*count*/) const override {
    const QString key = keyOf(QString::fromUtf8(context), QString::fromUtf8(text));
    const bool is_ours = key.startsWith(QLatin1String("hexoderm::"));
    if (is_ours && !known_.contains(key) && !known_.contains(keyOf("hexoderm", QString::fromUtf8(text)))) {
      missing_.insert(key);
    }
    return {};
  }
  [[nodiscard]] QStringList missing() const { return missing_.values(); }

 private:
  static QString keyOf(const QString& context, const QString& text) { return context + ": " + text; }
  QSet<QString> known_;
  mutable QSet<QString> missing_;
};

class GermanWindow : public WindowTest {
 protected:
  void SetUp() override {
    installTranslations(application(), "de");
    QCoreApplication::installTranslator(&missing_);
    WindowTest::SetUp();
  }
  void TearDown() override {
    QCoreApplication::removeTranslator(&missing_);
    window_.reset();
    installTranslations(application(), "en");
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
  installTranslations(application(), "de");
  EXPECT_EQ(QLocale().toString(1.5), "1,5");
  installTranslations(application(), "en");
  EXPECT_EQ(QLocale().toString(1.5), "1.5");
}

}  // namespace
}  // namespace hexoderm
