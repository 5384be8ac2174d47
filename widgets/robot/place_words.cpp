#include "widgets/robot/place_words.h"

#include "hexoderm/base/units.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace hexoderm {
namespace {

struct PlaceTexts {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PlaceOnRobot)
};

QString figure(double value) { return figureText(value, 1); }
QString nameOf(const PatchTurn& turn) { return QString::fromStdString(turn.link); }

void addChoices(const LinkCandidate& candidate, bool fits, std::vector<LinkChoice>& choices) {
  for (std::size_t k = 0; k < candidate.links.size(); ++k) {
    const QString link = nameOf(candidate.links[k]);
    if (k > 0) {
      choices.push_back(
          {link, PlaceTexts::tr("%1 · can't be told from %2").arg(link, nameOf(candidate.links.front()))});
      continue;
    }
    const QString text = fits ? PlaceTexts::tr("%1 · fits: misfit %2, usual is %3")
                              : PlaceTexts::tr("%1 · does not fit: misfit %2, usual is %3");
    choices.push_back({link, text.arg(link, figure(candidate.chi_squared), QString::number(candidate.freedom))});
  }
}

}  // namespace

std::vector<LinkChoice> linkChoices(const PatchLinks& patch) {
  std::vector<LinkChoice> choices;
  for (const LinkCandidate& candidate : patch.candidates) addChoices(candidate, true, choices);
  if (patch.nearest) addChoices(*patch.nearest, false, choices);
  return choices;
}

VerifySentence linkText(const PatchLinks& patch) {
  const Tone tone = patch.nearest                                   ? Tone::Bad
                    : patch.placed && patch.what_would_tell.empty() ? Tone::Good
                    : patch.candidates.empty()                      ? Tone::Bad
                                                                    : Tone::Caution;
  return {tone, QStringList({words(patch.why), words(patch.what_would_tell)}).join(QLatin1Char(' ')).trimmed()};
}

QString placeInList(const PlaceCandidate& candidate, std::size_t number, bool chosen) {
  QString text = PlaceTexts::tr("%1 · misfit %2").arg(number).arg(millimetresText(candidate.rms_m, 2));
  if (candidate.by_hand) text += QStringLiteral(" · ") + PlaceTexts::tr("put by hand");
  if (!candidate.fits) text += QStringLiteral(" · ") + PlaceTexts::tr("does not fit");
  const bool is_free = std::ranges::any_of(candidate.patches, [](const PlacedPatch& patch) {
    return std::ranges::any_of(patch.free, [](const FreeDirection& free) { return !free.held_by_rotation; });
  });
  if (is_free) text += QStringLiteral(" · ") + PlaceTexts::tr("can be moved");
  return chosen ? QStringLiteral("✓ ") + text : text;
}

VerifySentence placesText(const PlaceResult& result, std::size_t row) {
  VerifySentence sentence;
  switch (result.verdict) {
    case PlaceVerdict::Placed:
      sentence.tone = Tone::Good;
      break;
    case PlaceVerdict::Open:
    case PlaceVerdict::Several:
      sentence.tone = Tone::Caution;
      break;
    case PlaceVerdict::NoneFits:
    case PlaceVerdict::TooLarge:
      sentence.tone = Tone::Bad;
      break;
  }
  QStringList lines{words(result.summary)};
  for (const Message& remark : result.remarks) lines << words(remark);
  if (row < result.candidates.size()) {
    for (const PlacedPatch& patch : result.candidates[row].patches) {
      for (const FreeDirection& free : patch.free) {
        // The summary of the one place that was found to be open says these itself; below it is where a hand put it.
        const bool is_said = result.verdict == PlaceVerdict::Open && row == 0 && !free.held_by_rotation;
        if (!is_said) lines << words(free.words);
      }
    }
  }
  sentence.text = lines.join(QLatin1Char('\n'));
  return sentence;
}

QString pointText(const KnownPoint& point) {
  return PlaceTexts::tr("Cell %1 at (%2, %3, %4) mm ± %5 mm")
      .arg(point.cell.value())
      .arg(figure(toMillimetres(point.x_l.x())), figure(toMillimetres(point.x_l.y())),
           figure(toMillimetres(point.x_l.z())), figure(toMillimetres(point.sigma_m)));
}

QString distanceText(const KnownDistance& distance) {
  return PlaceTexts::tr("Cell %1 to cell %2: %3 mm ± %4 mm")
      .arg(distance.a.value())
      .arg(distance.b.value())
      .arg(figure(toMillimetres(distance.distance_m)), figure(toMillimetres(distance.sigma_m)));
}

VerifySentence together(const std::vector<VerifySentence>& sentences) {
  VerifySentence all;
  QStringList lines;
  for (const VerifySentence& sentence : sentences) {
    if (sentence.text.isEmpty()) continue;
    all.tone = std::max(all.tone, sentence.tone);
    lines << toneSign(sentence.tone) + QLatin1Char(' ') + sentence.text;
  }
  if (lines.size() == 1) lines.front().remove(0, toneSign(all.tone).size() + 1);
  all.text = lines.join(QLatin1Char('\n'));
  return all;
}

}  // namespace hexoderm
