#pragma once

#include "app/window/session/place_facts.h"

#include <QCoreApplication>

namespace hexoderm {

/// What went wrong in the step "Place on the robot", each where it is shown; empty: nothing did.
struct PlaceFaults {
  QString robot;
  QString joints;
  QString links;
  QString places;
  QString known;          ///< of points and distances
  QString places_remark;  ///< no fault: what was left out of the fit
};

/// What the step "Place on the robot" says of what is known, in the operator's language.
class PlaceSentences {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PlaceSentences)

 public:
  /// Both are read when something is asked, and outlive this.
  PlaceSentences(const PlaceFacts& facts, const PlaceFaults& faults) : facts_(facts), faults_(faults) {}

  [[nodiscard]] VerifySentence robot() const;
  [[nodiscard]] VerifySentence joints() const;
  [[nodiscard]] VerifySentence link(const PatchReconstruction& patch) const;
  [[nodiscard]] VerifySentence places() const;
  /// Of a patch that is being moved by hand.
  [[nodiscard]] static VerifySentence hand(const HandPlace& hand);
  /// The poses, patches and links that can be chosen.
  void addChoices(PlaceStand& stand) const;

 private:
  const PlaceFacts& facts_;
  const PlaceFaults& faults_;
};

}  // namespace hexoderm
