#include "app/window/settings/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <array>

// Outside of any namespace, as Qt asks for resources of static libraries.
static void initTranslationResources() { Q_INIT_RESOURCE(translations); }

namespace hexoderm {
namespace {

struct Language {
  const char* code;
  const char* name;
};
constexpr std::array<Language, 2> kLanguages = {{{"en", "English"}, {"de", "Deutsch"}}};
constexpr char kTranslatorName[] = "hexodermTranslator";

QString systemLanguage() {
  // "C" and "POSIX" are nobody's language.
  if (QLocale::system().language() == QLocale::C) return QStringLiteral("en");
  for (const QString& wanted : QLocale::system().uiLanguages()) {
    const QString code = wanted.left(2);
    if (shippedLanguages().contains(code)) return code;
  }
  return QStringLiteral("en");
}

QString folderOfQtsTexts() {
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  return QLibraryInfo::path(QLibraryInfo::TranslationsPath);
#else
  return QLibraryInfo::location(QLibraryInfo::TranslationsPath);
#endif
}

void install(QCoreApplication& application, const QString& file) {
  auto* translator = new QTranslator(&application);
  translator->setObjectName(QLatin1String(kTranslatorName));
  if (translator->load(file)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

}  // namespace

QStringList shippedLanguages() {
  QStringList codes;
  for (const Language& language : kLanguages) codes << QLatin1String(language.code);
  return codes;
}

QString languageName(const QString& language) {
  for (const Language& shipped : kLanguages) {
    if (language == QLatin1String(shipped.code)) return QString::fromUtf8(shipped.name);
  }
  return language;
}

bool isLanguageChoice(const QString& language) {
  return language == QLatin1String(kSystemLanguage) || shippedLanguages().contains(language);
}

QString installTranslations(QCoreApplication& application, const QString& language) {
  initTranslationResources();
  const bool is_asked_for = shippedLanguages().contains(language);
  const QString code = is_asked_for ? language : systemLanguage();
  const bool is_systems = !is_asked_for || QLocale::system().name().startsWith(code);
  QLocale::setDefault(is_systems ? QLocale::system() : QLocale(code));

  for (QTranslator* old : application.findChildren<QTranslator*>(QLatin1String(kTranslatorName))) {
    QCoreApplication::removeTranslator(old);
    delete old;
  }
  if (code != QStringLiteral("en")) {
    // The one installed last is asked first.
    install(application, folderOfQtsTexts() + QStringLiteral("/qtbase_") + code + QStringLiteral(".qm"));
    install(application, QStringLiteral(":/hexoderm/translations/hexoderm_") + code + QStringLiteral(".qm"));
  }
  return code;
}

}  // namespace hexoderm
