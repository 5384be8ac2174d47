#pragma once

#include "widgets/coloring/coloring.h"

#include <QObject>
#include <cmath>
#include <map>
#include <optional>

namespace hexoderm {

/// The ranges of scales that the operator has fixed, shared by all views: what is fixed in one of them is so in all,
/// and stays so with the next result. The scales of all other colourings are fitted to what is shown.
class ScaleRanges : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  [[nodiscard]] std::optional<ColorRange> fixed(Coloring coloring) const {
    const auto found = fixed_.find(coloring);
    return found == fixed_.end() ? std::nullopt : std::optional(found->second);
  }

  /// A range that is none (low not below high, or not finite) is not taken.
  void fix(Coloring coloring, const ColorRange& range) {
    if (!(range.low < range.high) || !std::isfinite(range.low) || !std::isfinite(range.high)) return;
    if (!isQuantity(coloring) || fixed(coloring) == range) return;
    fixed_[coloring] = range;
    emit changed(coloring);
  }

  void release(Coloring coloring) {
    if (fixed_.erase(coloring) > 0) emit changed(coloring);
  }

 signals:
  void changed(hexoderm::Coloring coloring);

 private:
  std::map<Coloring, ColorRange> fixed_;
};

}  // namespace hexoderm
