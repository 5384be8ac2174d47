#pragma once

#include <QString>
#include <QStringList>

class QCoreApplication;

namespace hexoderm {

/// Instead of a language's code: what the system says.
inline constexpr char kSystemLanguage[] = "system";

/// The languages that Hexoderm has texts in, as their two-letter codes, English first.
QStringList shippedLanguages();

/// The language's own name, for one of shippedLanguages().
QString languageName(const QString& language);

/// kSystemLanguage or one of shippedLanguages().
bool isLanguageChoice(const QString& language);

/// Installs Hexoderm's texts, and Qt's own if they are on this computer. Must be called before the first window is
/// made: visible texts keep their language. A chosen language brings its way of writing numbers; with "system" (or
/// anything else) both are the system's, or English if its language is not shipped. Returns the code of the language
/// that texts are in now.
QString installTranslations(QCoreApplication& application, const QString& language);

}  // namespace hexoderm
