#include "widgets/words/core_words.h"

#include "widgets/words/core_words_catalogue.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QMutex>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <optional>
#include <vector>

namespace hexoderm {
namespace {

// Texts within texts: a reason that quotes a finding that names a link. Deeper is nothing that core says.
constexpr int kDeepest = 5;
// Places at which core's own sentence, or a file's name, may end in a text that quotes another: what somebody pasted
// can hold hundreds.
constexpr std::size_t kMostEnds = 10;

const QRegularExpression& placeholder() {
  static const QRegularExpression pattern(QStringLiteral("%[1-9]"));
  return pattern;
}

struct Template {
  const char* english = nullptr;
  QRegularExpression pattern;
  int literal_size = 0;          ///< characters that are not placeholders: what has more of them says more
  std::vector<int> placeholder;  ///< number of the k-th one in the text
};

Template makeTemplate(const char* english) {
  Template result;
  result.english = english;
  const QString text = QString::fromUtf8(english);
  // What stands at a placeholder is no more than a sentence: the next one has a template of its own.
  const QString argument = QStringLiteral("((?:(?!\\. ).)+?)");
  QString pattern;
  int from = 0;
  for (auto it = placeholder().globalMatch(text); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    pattern += QRegularExpression::escape(text.mid(from, match.capturedStart() - from)) + argument;
    result.placeholder.push_back(match.captured().at(1).digitValue());
    from = match.capturedEnd();
  }
  pattern += QRegularExpression::escape(text.mid(from));
  result.pattern =
      QRegularExpression(QRegularExpression::anchoredPattern(pattern), QRegularExpression::DotMatchesEverythingOption);
  result.literal_size = text.size() - 2 * static_cast<int>(result.placeholder.size());
  return result;
}

/// The text up to its first blank, which is what templates are found by.
QString firstWord(const QString& text) { return text.left(text.indexOf(QLatin1Char(' '))); }

class Catalogue {
 public:
  Catalogue() {
    for (const char* english : coreTemplates()) templates_.push_back(makeTemplate(english));
    std::stable_sort(templates_.begin(), templates_.end(),
                     [](const Template& a, const Template& b) { return a.literal_size > b.literal_size; });
    for (const Template& entry : templates_) {
      const QString word = firstWord(QString::fromUtf8(entry.english));
      (word.contains(placeholder()) ? others_ : by_first_word_[word]).push_back(&entry);
    }
  }

  [[nodiscard]] std::optional<QString> translate(const QString& text, int depth) const {
    const auto found = by_first_word_.constFind(firstWord(text));
    if (found != by_first_word_.constEnd()) {
      for (const Template* entry : *found) {
        if (auto words = fill(*entry, text, depth)) return words;
      }
    }
    for (const Template* entry : others_) {
      if (auto words = fill(*entry, text, depth)) return words;
    }
    return std::nullopt;
  }

 private:
  static std::optional<QString> fill(const Template& entry, const QString& text, int depth);

  std::vector<Template> templates_;  ///< what says most comes first
  QHash<QString, std::vector<const Template*>> by_first_word_;
  std::vector<const Template*> others_;  ///< those that begin with a placeholder
};

const Catalogue& catalogue() {
  static const Catalogue the_catalogue;
  return the_catalogue;
}

std::optional<QString> wordsOf(const QString& text, int depth);

QString withLocalPoint(QString number) { return number.replace(QLatin1Char('.'), QString(QLocale().decimalPoint())); }

QString argumentWords(const QString& text, int depth) {
  static const QRegularExpression number(QStringLiteral("^[±+-]?\\d+(\\.\\d+)?( ?[^\\s\\d.,]{1,5})?$"));
  static const QRegularExpression list(QStringLiteral("^(\\d+(?:, \\d+)*) and (\\d+)$"));
  if (auto words = wordsOf(text, depth)) return *words;
  if (number.match(text).hasMatch()) return withLocalPoint(text);
  const QRegularExpressionMatch items = list.match(text);
  if (items.hasMatch()) {
    return QCoreApplication::translate("hexoderm::CoreWords", "%1 and %2", "the end of a list")
        .arg(items.captured(1), items.captured(2));
  }
  return text;
}

std::optional<QString> Catalogue::fill(const Template& entry, const QString& text, int depth) {
  const QRegularExpressionMatch match = entry.pattern.match(text);
  if (!match.hasMatch()) return std::nullopt;
  const QString translated = QCoreApplication::translate(kCoreWordsContext, entry.english);
  QString words;
  int from = 0;
  for (auto it = placeholder().globalMatch(translated); it.hasNext();) {
    const QRegularExpressionMatch place = it.next();
    const auto k = std::find(entry.placeholder.begin(), entry.placeholder.end(), place.captured().at(1).digitValue());
    words += translated.mid(from, place.capturedStart() - from);
    if (k != entry.placeholder.end()) {
      words += argumentWords(match.captured(1 + static_cast<int>(k - entry.placeholder.begin())), depth + 1);
    }
    from = place.capturedEnd();
  }
  return words + translated.mid(from);
}

/// The first places at which two parts of the text meet.
std::vector<int> endsAt(const QString& between, const QString& text) {
  std::vector<int> ends;
  for (int end = text.indexOf(between); end >= 0 && ends.size() < kMostEnds; end = text.indexOf(between, end + 1)) {
    ends.push_back(end);
  }
  return ends;
}

/// Sentences one after another, each with a template.
std::optional<QString> sentences(const QString& text, int depth) {
  for (const int end : endsAt(QStringLiteral(". "), text)) {
    const auto first = catalogue().translate(text.left(end + 1), depth);
    if (!first) continue;
    const QString rest = text.mid(end + 2);
    return *first + QLatin1Char(' ') + wordsOf(rest, depth + 1).value_or(rest);
  }
  return std::nullopt;
}

/// "FILE: what is wrong": the file is not translated.
std::optional<QString> afterName(const QString& text, int depth) {
  for (const int end : endsAt(QStringLiteral(": "), text)) {
    if (const auto rest = catalogue().translate(text.mid(end + 2), depth)) return text.left(end + 2) + *rest;
  }
  return std::nullopt;
}

/// "17 cells, 16 links, 1 patch".
std::optional<QString> counts(const QString& text, int depth) {
  if (text.isEmpty() || !text.front().isDigit()) return std::nullopt;
  QStringList words;
  for (const QString& part : text.split(QStringLiteral(", "))) {
    const auto translated = catalogue().translate(part, depth);
    if (!translated) return std::nullopt;
    words << *translated;
  }
  return words.size() > 1 ? std::optional(words.join(QStringLiteral(", "))) : std::nullopt;
}

std::optional<QString> wordsOf(const QString& text, int depth) {
  if (depth > kDeepest || text.isEmpty()) return std::nullopt;
  if (auto words = counts(text, depth)) return words;
  if (auto words = catalogue().translate(text, depth)) return words;
  if (auto words = sentences(text, depth)) return words;
  return afterName(text, depth);
}

struct Memory {
  QMutex mutex;
  QHash<QByteArray, QString> words;
};
Memory& memory() {
  static Memory the_memory;
  return the_memory;
}

}  // namespace

QString coreWords(const std::string& english) {
  constexpr int kMostRemembered = 4000;
  const QByteArray key(english.data(), static_cast<int>(english.size()));
  {
    const QMutexLocker lock(&memory().mutex);
    const auto known = memory().words.constFind(key);
    if (known != memory().words.constEnd()) return *known;
  }
  const QString text = QString::fromUtf8(key);
  const QString words = argumentWords(text, 0);
  const QMutexLocker lock(&memory().mutex);
  // Texts with figures that change all the time must not fill the memory.
  if (memory().words.size() >= kMostRemembered) memory().words.clear();
  memory().words.insert(key, words);
  return words;
}

void forgetCoreWords() {
  const QMutexLocker lock(&memory().mutex);
  memory().words.clear();
}

}  // namespace hexoderm
