#pragma once

#include "app/window/session/place_facts.h"

#include <QCoreApplication>
#include <vector>

namespace hexoderm {

class SessionController;

/// The operator's decisions about the patch that is spoken of, written into the session as edits that can be undone.
/// Each returns why it can't be taken, in the operator's language; empty: it was taken, or changes nothing.
class PlaceDecisions {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PlaceDecisions)

 public:
  /// Both outlive this.
  PlaceDecisions(SessionController& controller, const PlaceFacts& facts) : controller_(controller), facts_(facts) {}

  /// Empty: the link is left open.
  QString chooseLink(const QString& link);
  QString useSurface(bool by_surface);
  QString addPoint(const KnownPoint& point);
  QString removePoint(int index);
  QString addDistance(const KnownDistance& distance);
  QString removeDistance(int index);
  /// One of the places that were found, by its row; `text` names the edit.
  QString choosePlace(int row, const QString& text);
  QString takeAway();

 private:
  QString decide(std::vector<PatchPlacement> placements, const QString& text);

  SessionController& controller_;
  const PlaceFacts& facts_;
};

}  // namespace hexoderm
