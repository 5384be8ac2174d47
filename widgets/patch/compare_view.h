#pragma once

#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/util/units.h"
#include "widgets/coloring/coloring.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/patch/camera_link.h"
#include "widgets/patch/patch_view.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSlider>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

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
  explicit CompareView(Selection* selection, QWidget* parent = nullptr)
      : QWidget(parent), parts_(std::make_unique<Parts>(this, selection)) {
    setNames(this, QStringLiteral("compareView"), tr("Before and after"));
    parts_->build();
  }

  ~CompareView() override { parts_->cameras.reset(); }

  void setContent(const Content& content) {
    parts_->content = content;
    parts_->show();
  }

  /// The results that can be "before", in words; `why_none` is said where there are none.
  void setSources(const QStringList& sources, int chosen, const QString& why_none) {
    parts_->is_filling = true;
    parts_->source->clear();
    parts_->source->addItems(sources);
    parts_->source->setCurrentIndex(chosen);
    parts_->source->setEnabled(!sources.isEmpty());
    // What the box asks for leaves out the frame of its arrow.
    parts_->source->setMinimumWidth(parts_->source->sizeHint().width() +
                                    parts_->source->fontMetrics().averageCharWidth());
    parts_->is_filling = false;
    if (sources.isEmpty()) parts_->summary->setText(why_none);
    disconnect(parts_->source, nullptr, this, nullptr);
    connect(parts_->source, qOverload<int>(&QComboBox::activated), this, &CompareView::sourceChosen);
  }

  void setMode(Mode mode) {
    parts_->mode = mode;
    parts_->show();
  }

  [[nodiscard]] Mode mode() const { return parts_->mode; }
  [[nodiscard]] PatchView& before() const { return *parts_->before; }
  [[nodiscard]] PatchView& now() const { return *parts_->now; }
  /// As the arrows are drawn.
  [[nodiscard]] std::optional<double> factor() const { return parts_->now->shiftFactor(); }

 signals:
  void sourceChosen(int index);

 private:
  /// The steps of the slider: those in which arrows are enlarged by themselves.
  static constexpr std::array kFactors = {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};
  static QLabel* caption(const char* name, const QString& text) {
    auto* label = new QLabel(text);
    label->setObjectName(QLatin1String(name));
    label->setProperty("caption", true);
    label->setTextFormat(Qt::PlainText);
    return label;
  }

  /// The cell that lies farthest from where it was; null without any.
  static const CellDifference* farthestMoved(const std::vector<Comparison>& comparisons) {
    const CellDifference* farthest = nullptr;
    for (const Comparison& comparison : comparisons) {
      for (const CellDifference& cell : comparison.cells) {
        if (farthest == nullptr || cell.position_m.norm() > farthest->position_m.norm()) farthest = &cell;
      }
    }
    return farthest;
  }

  struct Parts {
    Parts(CompareView* owner, Selection* selection)
        : view(owner), before(new PatchView(selection)), now(new PatchView(selection)) {}

    CompareView* view;
    PatchView* before;
    PatchView* now;
    std::unique_ptr<CameraLink> cameras;
    Content content;
    Mode mode = Mode::SideBySide;
    bool is_filling = false;

    QComboBox* source = new QComboBox;
    QToolButton* side_by_side = new QToolButton;
    QToolButton* arrows = new QToolButton;
    QWidget* enlarged = new QWidget;
    QSlider* slider = new QSlider(Qt::Horizontal);
    QLabel* factor_label = new QLabel;
    QWidget* before_pane = new QWidget;
    QLabel* summary = new QLabel;

    void build() {
      auto* layout = spaced(new QVBoxLayout(view), {10, 8, 10, 8}, 6);
      buildHead(layout);
      const auto pane = [](QWidget* holder, QLabel* title, PatchView* patch) {
        auto* column = spaced(new QVBoxLayout(holder), {0, 0, 0, 0}, 2);
        column->addWidget(title);
        column->addWidget(patch, 1);
      };
      pane(before_pane, caption("compareBeforeTitle", CompareView::tr("BEFORE")), before);
      auto* now_pane = new QWidget;
      pane(now_pane, caption("compareNowTitle", CompareView::tr("NOW")), now);
      setNames(before, QStringLiteral("compareBefore"), CompareView::tr("The patch before"));
      setNames(now, QStringLiteral("compareNow"), CompareView::tr("The patch now"));
      auto* panes = spaced(new QHBoxLayout, 8);
      panes->addWidget(before_pane, 1);
      panes->addWidget(now_pane, 1);
      layout->addLayout(panes, 1);
      summary->setObjectName(QStringLiteral("compareSummary"));
      summary->setWordWrap(true);
      layout->addWidget(summary);
      cameras = std::make_unique<CameraLink>(*before, *now);
      connect(before, &PatchView::coloringChanged, now, &PatchView::setColoring);
      connect(now, &PatchView::coloringChanged, before, &PatchView::setColoring);
    }

    void buildHead(QVBoxLayout* layout) {
      source->setObjectName(QStringLiteral("compareSource"));
      source->setSizeAdjustPolicy(QComboBox::AdjustToContents);
      source->setAccessibleName(CompareView::tr("What the result of now is compared with"));
      auto* from = new QLabel(CompareView::tr("Before:"));
      from->setBuddy(source);
      auto* modes = new QButtonGroup(view);
      const auto add = [&](QToolButton* button, const char* name, const QString& text, const QString& tip) {
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setToolTip(tip);
        button->setCheckable(true);
        modes->addButton(button);
      };
      add(side_by_side, "compareSideBySide", CompareView::tr("Side by side"),
          CompareView::tr("Both results, seen from the same side"));
      add(arrows, "compareArrows", CompareView::tr("Arrows"),
          CompareView::tr("The result of now, with an arrow from where each cell was"));
      side_by_side->setChecked(true);
      connect(side_by_side, &QToolButton::clicked, view, [this] { view->setMode(Mode::SideBySide); });
      connect(arrows, &QToolButton::clicked, view, [this] { view->setMode(Mode::Arrows); });
      setNames(slider, QStringLiteral("compareFactor"), CompareView::tr("Enlargement of the arrows"));
      slider->setRange(0, static_cast<int>(kFactors.size()) - 1);
      slider->setPageStep(3);
      slider->setMinimumWidth(24 * view->fontMetrics().averageCharWidth());
      connect(slider, &QSlider::valueChanged, view, [this](int step) {
        if (is_filling) return;
        now->setShiftFactor(kFactors.at(static_cast<std::size_t>(step)));
        showFactor();
      });
      factor_label->setObjectName(QStringLiteral("compareFactorLabel"));
      auto* row = spaced(new QHBoxLayout(enlarged), {8, 0, 0, 0});
      row->addWidget(new QLabel(CompareView::tr("Arrows enlarged")));
      addWidgets(row, {slider, factor_label});
      auto* head = new FlowLayout;
      for (QWidget* widget : std::initializer_list<QWidget*>{from, source, side_by_side, arrows, enlarged}) {
        head->addWidget(widget);
      }
      layout->addLayout(head);
      enlarged->hide();
    }

    void show() {
      const bool with_arrows = mode == Mode::Arrows;
      before_pane->setVisible(!with_arrows);
      enlarged->setVisible(with_arrows);
      (with_arrows ? arrows : side_by_side)->setChecked(true);
      before->setReconstruction(with_arrows ? nullptr : content.before);
      if (now->overlays().comparison != nullptr || with_arrows) {
        PatchOverlays overlays;
        if (with_arrows) overlays.comparison = content.comparison;
        now->setOverlays(overlays);
      }
      now->setReconstruction(content.now);
      summary->setText(inWords());
      showFactor();
    }

    void showFactor() {
      const std::optional<double> shown = now->shiftFactor();
      slider->setEnabled(shown.has_value());
      factor_label->setText(shown ? CompareView::tr("%1 times").arg(QLocale().toString(*shown, 'f', 0)) : noValue());
      if (!shown) return;
      is_filling = true;
      const auto step = std::ranges::lower_bound(kFactors, *shown - 0.5) - kFactors.begin();
      slider->setValue(static_cast<int>(step));
      is_filling = false;
    }

    QString inWords() const {
      if (!content.before || !content.comparison) return {};
      const ComparisonSummary all = summariseComparisons(*content.comparison);
      const CellDifference* farthest = farthestMoved(*content.comparison);
      if (all.cells == 0 || farthest == nullptr) return CompareView::tr("The two have no cells in common.");
      return CompareView::tr(
                 "%1 cells in common. Between before and now they lie %2 apart and are turned by %3 (rms, after "
                 "the best fit of both); cell %4 has moved most, by %5.")
          .arg(QString::number(all.cells), millimetresInWords(all.position_rms_m, 2),
               degreesInWords(all.orientation_rms_rad), QString::number(farthest->cell.value()),
               millimetresInWords(farthest->position_m.norm(), 2));
    }
  };

  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
