#pragma once

// Texts of Qt in tests: how they are printed, and matchers for parts of them.

#include <gmock/gmock.h>
#include <QString>
#include <ostream>

inline void PrintTo(const QString& text, std::ostream* out) { *out << '"' << text.toStdString() << '"'; }

namespace hexoderm {

MATCHER_P(HasText, part, "") { return QString(arg).contains(QString(part)); }
MATCHER_P(BeginsWith, part, "") { return QString(arg).startsWith(QString(part)); }

}  // namespace hexoderm
