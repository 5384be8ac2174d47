#pragma once

// Texts of Qt in tests: how they are printed, and matchers for parts of them.

#include <gmock/gmock.h>
#include <QStringList>
#include <ostream>
#include <vector>

inline void PrintTo(const QString& text, std::ostream* out) { *out << '"' << text.toStdString() << '"'; }

namespace hexoderm {

MATCHER_P(HasText, part, "") { return QString(arg).contains(QString(part)); }
/// A text that has all of these parts.
inline auto HasTexts(const QStringList& parts) {
  std::vector<testing::Matcher<const QString&>> all;
  for (const QString& part : parts) all.push_back(HasText(part));
  return testing::AllOfArray(all);
}
MATCHER_P(BeginsWith, part, "") { return QString(arg).startsWith(QString(part)); }

}  // namespace hexoderm
