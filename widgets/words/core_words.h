#pragma once

#include <QString>
#include <string>

namespace hexoderm {

/// What core says to people, in the language of the window.
///
/// Core knows no Qt and speaks English: findings, verdicts, advice, what a hold waits for, where a source stands, why a
/// file can't be read. The text is looked up in a catalogue of templates ("Cell %1 is listed more than once; ...");
/// what stands at the placeholders goes into the translation of the template: numbers with the locale's decimal point,
/// lists and parts that have templates of their own translated, names and paths as they are. A text without a template
/// stays as it is. Quick: what was translated once is remembered. May be called from any thread.
QString coreWords(const std::string& english);

/// To be called after translators were installed or removed: what was remembered is in another language.
void forgetCoreWords();

}  // namespace hexoderm
