#pragma once

#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/reconstruction/result/reconstruction.h"
#include "widgets/coloring/coloring.h"
#include "widgets/style/palette.h"

#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

class PatchView;
class Selection;

/// Before and after: two results of a skin side by side, with cameras, colours and selection in common, or the one of
/// now with an arrow from where each cell was, enlarged as far as the slider says.
class CompareView : public QWidget {
  Q_OBJECT

 public:
  enum class Mode { SideBySide, Arrows };

  struct Content {
    std::shared_ptr<const Reconstruction> before;  ///< null: there is nothing to compare with
    std::shared_ptr<const Reconstruction> now;
    std::shared_ptr<const std::vector<Comparison>> comparison;  ///< of now with before
  };

  /// `selection` must outlive the view.
  explicit CompareView(Selection* selection, QWidget* parent = nullptr);
  ~CompareView() override;

  void setContent(const Content& content);
  /// The results that can be "before", in words; `why_none` is said where there are none.
  void setSources(const QStringList& sources, int chosen, const QString& why_none);
  void setMode(Mode mode);
  [[nodiscard]] Mode mode() const;
  [[nodiscard]] PatchView& before() const;
  [[nodiscard]] PatchView& now() const;
  /// As the arrows are drawn.
  [[nodiscard]] std::optional<double> factor() const;

 signals:
  void sourceChosen(int index);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
