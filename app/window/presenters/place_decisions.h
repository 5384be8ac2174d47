#pragma once

#include "app/window/session/place_facts.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/base/error.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <utility>
#include <vector>

namespace hexoderm {

/// The operator's decisions about the patch that is spoken of, written into the session as edits that can be undone.
/// Each returns why it can't be taken, in the operator's language; empty: it was taken, or changes nothing.
class PlaceDecisions {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PlaceDecisions)

 public:
  /// Both outlive this.
  PlaceDecisions(SessionController& controller, const PlaceFacts& facts) : controller_(controller), facts_(facts) {}

  /// Empty: the link is left open.
  QString chooseLink(const QString& link) {
    const PatchReconstruction* of = facts_.patch();
    if (of == nullptr) return {};
    PatchPlacement placement = facts_.decided(*of);
    const std::string name = link.toStdString();
    const PatchLinks* links = facts_.linksOf(*of);
    if (placement.link == name) return {};
    // The only one that fits is no choice against others.
    const bool is_alone = links != nullptr && links->placed && !links->chosen && links->placed->link == name;
    if (is_alone && placement.link.empty()) return {};
    if (facts_.linkOf(*of) != name) {
      // They are those of the link that was chosen before.
      placement.points.clear();
      placement.distances.clear();
      placement.place.reset();
    }
    placement.link = name;
    placement.link_chosen = !is_alone && !name.empty();
    return decide({placement}, name.empty() ? tr("leave the link open") : tr("put the patch on link %1").arg(link));
  }

  QString useSurface(bool by_surface) {
    return change(by_surface ? tr("use the surface of the link") : tr("do without the surface of the link"),
                  [&](PatchPlacement& placement) { placement.by_surface = by_surface; });
  }

  QString addPoint(const KnownPoint& point) {
    const PatchReconstruction* of = facts_.patch();
    if (of != nullptr && of->findCell(point.cell) == nullptr) {
      return tr("Cell %1 is none of this patch.").arg(point.cell.value());
    }
    return change(tr("add a known point"), [&](PatchPlacement& placement) {
      placement.link = facts_.linkOf(*of);
      placement.points.push_back(point);
    });
  }

  QString removePoint(int index) { return removeAt(&PatchPlacement::points, index, tr("remove a known point")); }

  QString addDistance(const KnownDistance& distance) {
    const PatchReconstruction* of = facts_.patch();
    if (of == nullptr) return {};
    const PatchReconstruction* other = facts_.patchOf(distance.b);
    if (of->findCell(distance.a) == nullptr) return tr("Cell %1 is none of this patch.").arg(distance.a.value());
    if (other == nullptr || other == of) {
      return tr("Cell %1 is of no other patch: inside a patch, distances are known.").arg(distance.b.value());
    }
    if (facts_.linkOf(*other) != facts_.linkOf(*of)) {
      return tr("The patch of cell %1 is not on link %2: its distance depends on the joints.")
          .arg(distance.b.value())
          .arg(QString::fromStdString(facts_.linkOf(*of)));
    }
    return change(tr("add a measured distance"), [&](PatchPlacement& placement) {
      placement.link = facts_.linkOf(*of);
      placement.distances.push_back(distance);
    });
  }

  QString removeDistance(int index) {
    return removeAt(&PatchPlacement::distances, index, tr("remove a measured distance"));
  }

  /// One of the places that were found, by its row; `text` names the edit.
  QString choosePlace(int row, const QString& text) {
    if (!facts_.places || row < 0 || static_cast<std::size_t>(row) >= facts_.places->candidates.size()) return {};
    if (row == facts_.rowOfPlace()) return {};
    std::vector<PatchPlacement> placements;
    for (const PlacedPatch& placed : facts_.places->candidates[static_cast<std::size_t>(row)].patches) {
      const PatchReconstruction* of = facts_.patchOf(placed.place.origin);
      if (of == nullptr) return {};
      PatchPlacement placement = facts_.decided(*of);
      placement.link = placed.place.link;
      placement.place = placed.place;
      placements.push_back(std::move(placement));
    }
    return decide(std::move(placements), text);
  }

  QString takeAway() {
    return change(tr("take the patch away"), [](PatchPlacement& placement) { placement.place.reset(); });
  }

 private:
  template <class Change>
  QString change(const QString& text, const Change& make) {
    const PatchReconstruction* of = facts_.patch();
    if (of == nullptr) return {};
    PatchPlacement placement = facts_.decided(*of);
    make(placement);
    return decide({placement}, text);
  }

  template <class T>
  QString removeAt(std::vector<T> PatchPlacement::*list, int index, const QString& text) {
    const PatchReconstruction* of = facts_.patch();
    if (of == nullptr) return {};
    PatchPlacement placement = facts_.decided(*of);
    std::vector<T>& items = placement.*list;
    if (index < 0 || index >= static_cast<int>(items.size())) return {};
    items.erase(items.begin() + index);
    return decide({placement}, text);
  }

  QString decide(std::vector<PatchPlacement> placements, const QString& text) {
    if (!controller_.session() || !facts_.solved) return {};
    std::vector<SessionEdit> edits;
    try {
      for (PatchPlacement& placement : placements) {
        placement.validate();
        // What was decided when the patch had another origin cell is in it, moved to this one.
        const PatchReconstruction* of = facts_.patchOf(placement.origin);
        for (const PatchPlacement& other : controller_.session()->placements()) {
          if (other.origin == placement.origin || of == nullptr || of->findCell(other.origin) == nullptr) continue;
          PatchPlacement nothing;
          nothing.origin = other.origin;
          edits.emplace_back(SetPatchPlacement{nothing});
        }
        edits.emplace_back(SetPatchPlacement{std::move(placement)});
      }
    } catch (const InvalidArgument& error) {
      return words(error);
    }
    controller_.perform(edits, text);
    return {};
  }

  SessionController& controller_;
  const PlaceFacts& facts_;
};

}  // namespace hexoderm
