#pragma once

#include "hexoderm/base/message.h"

#include <QString>
#include <exception>

namespace hexoderm {

/// The context of all of core's templates in the files for Qt Linguist; packaging/messages.py writes it there.
inline constexpr char kMessageContext[] = "hexoderm::Message";

/// A message in the language of the window. Core knows no Qt and speaks English; its template is looked up in the
/// translations, and the arguments take their places in it: numbers with the locale's decimal point, lists and messages
/// within the message translated, names and paths as they are. A template without a translation stays English. May be
/// called from any thread.
QString words(const Message& message);
/// The message of an Error; of any other exception its text as it is.
QString words(const std::exception& error);

}  // namespace hexoderm
