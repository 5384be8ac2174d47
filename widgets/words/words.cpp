#include "widgets/words/words.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/said_items.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

QString wordsOf(std::int64_t count) { return QString::number(count); }
QString wordsOf(const std::string& text) { return QString::fromStdString(text); }
QString wordsOf(const Message& message) { return words(message); }
QString wordsOf(const Quantity& quantity) {
  return QString::fromStdString(MessageArgument(quantity).english())
      .replace(QLatin1Char('.'), QString(QLocale().decimalPoint()));
}
QString filled(const QString& words, const std::vector<std::string>& arguments) {
  return QString::fromStdString(fillTemplate(words.toStdString(), arguments));
}
QString wordsOf(const MessageArgument::List& items) {
  QString text;
  const std::size_t said = saidOf(items.size());
  for (std::size_t k = 0; k < said; ++k) {
    const QString item = std::visit([](const auto& held) { return wordsOf(held); }, items[k].value);
    if (k == 0) {
      text = item;
    } else if (k + 1 < items.size()) {
      text += QStringLiteral(", ") + item;
    } else {
      // Its context as a literal, because lupdate reads it here.
      text = filled(QCoreApplication::translate("hexoderm::Message", "{} and {}", "the end of a list"),
                    {text.toStdString(), item.toStdString()});
    }
  }
  if (said == items.size()) return text;
  return filled(QCoreApplication::translate("hexoderm::Message", "{} and {} others", "the end of a long list"),
                {text.toStdString(), std::to_string(items.size() - said)});
}

/// Messages in a row ("{}, {}") have nothing to translate but themselves.
bool hasWords(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c >= 0x80 || std::isalpha(c) != 0; });
}

}  // namespace

QString words(const Message& message) {
  if (message.empty()) return {};
  std::vector<std::string> arguments;
  arguments.reserve(message.arguments().size());
  for (const MessageArgument& argument : message.arguments()) {
    arguments.push_back(std::visit([](const auto& held) { return wordsOf(held); }, argument.value).toStdString());
  }
  const std::string& english = message.englishTemplate();
  return filled(hasWords(english) ? QCoreApplication::translate(kMessageContext, english.c_str())
                                  : QString::fromStdString(english),
                arguments);
}

QString words(const std::exception& error) { return words(messageOf(error)); }

}  // namespace hexoderm
