#pragma once

#include "hexoderm/base/units.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/coloring/coloring.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/patch/patch_view.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// Two views of one skin look at it from the same side: whoever moves the camera of one moves that of the other.
class CameraLink {
 public:
  /// Both views outlive the link. Without OpenGL it does nothing.
  CameraLink(PatchView& a, PatchView& b) : views_{&a, &b} {
    for (std::size_t k = 0; k < 2; ++k) {
      vtkCamera* camera = views_.at(k)->camera();
      if (camera != nullptr)
        observers_.at(k) = camera->AddObserver(vtkCommand::ModifiedEvent, this, &CameraLink::follow);
    }
  }

  ~CameraLink() {
    for (std::size_t k = 0; k < 2; ++k) {
      if (observers_.at(k) != 0) views_.at(k)->camera()->RemoveObserver(observers_.at(k));
    }
  }

  CameraLink(const CameraLink&) = delete;
  CameraLink& operator=(const CameraLink&) = delete;

 private:
  void follow(vtkObject* moved, unsigned long /*event*/, void* /*data*/) {
    if (is_following_) return;
    is_following_ = true;
    PatchView& other = *views_.at(moved == views_[0]->camera() ? 1 : 0);
    auto* from = static_cast<vtkCamera*>(moved);
    vtkCamera* to = other.camera();
    const unsigned long before = to->GetMTime();
    to->SetPosition(from->GetPosition());
    to->SetFocalPoint(from->GetFocalPoint());
    to->SetViewUp(from->GetViewUp());
    to->SetViewAngle(from->GetViewAngle());
    to->SetParallelProjection(from->GetParallelProjection());
    to->SetParallelScale(from->GetParallelScale());
    // A picture of its own, and what depends on its shape (WindowCenter, clipping), stays with each view.
    if (to->GetMTime() != before) other.redraw();
    is_following_ = false;
  }

  std::array<PatchView*, 2> views_;
  std::array<unsigned long, 2> observers_{};
  bool is_following_ = false;  ///< what moves now was moved here
};

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
      : QWidget(parent),
        before_(named(new PatchView(selection), "compareBefore", tr("The patch before"))),
        now_(named(new PatchView(selection), "compareNow", tr("The patch now"))) {
    setNames(this, QStringLiteral("compareView"), tr("Before and after"));
    auto* layout = spaced(new QVBoxLayout(this), {10, 8, 10, 8}, 6);
    buildHead(layout);
    auto* panes = spaced(new QHBoxLayout, 8);
    before_pane_ = addPane(panes, "compareBeforeTitle", tr("BEFORE"), before_);
    addPane(panes, "compareNowTitle", tr("NOW"), now_);
    layout->addLayout(panes, 1);
    summary_->setWordWrap(true);
    layout->addWidget(summary_);
    cameras_ = std::make_unique<CameraLink>(*before_, *now_);
    connect(before_, &PatchView::coloringChanged, now_, &PatchView::setColoring);
    connect(now_, &PatchView::coloringChanged, before_, &PatchView::setColoring);
  }

  void setContent(const Content& content) {
    content_ = content;
    showContent();
  }

  /// The results that can be "before", in words; `why_none` is said where there are none.
  void setSources(const QStringList& sources, int chosen, const QString& why_none) {
    source_->clear();
    source_->addItems(sources);
    source_->setCurrentIndex(chosen);
    source_->setEnabled(!sources.isEmpty());
    // What the box asks for leaves out the frame of its arrow.
    source_->setMinimumWidth(source_->sizeHint().width() + source_->fontMetrics().averageCharWidth());
    if (sources.isEmpty()) summary_->setText(why_none);
  }

  void setMode(Mode mode) {
    mode_ = mode;
    showContent();
  }

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] PatchView& before() const { return *before_; }
  [[nodiscard]] PatchView& now() const { return *now_; }
  /// As the arrows are drawn.
  [[nodiscard]] std::optional<double> factor() const { return now_->shiftFactor(); }

 signals:
  void sourceChosen(int index);

 private:
  /// The steps of the slider: those in which arrows are enlarged by themselves.
  static constexpr std::array kFactors = {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};

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

  static QWidget* addPane(QHBoxLayout* panes, const char* name, const QString& text, PatchView* patch) {
    auto* title = styledAs(named(new QLabel(text), name), "caption");
    title->setTextFormat(Qt::PlainText);
    auto* pane = new QWidget;
    auto* column = spaced(new QVBoxLayout(pane), {0, 0, 0, 0}, 2);
    column->addWidget(title);
    column->addWidget(patch, 1);
    panes->addWidget(pane, 1);
    return pane;
  }

  void buildHead(QVBoxLayout* layout) {
    source_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(source_, qOverload<int>(&QComboBox::activated), this, &CompareView::sourceChosen);
    auto* modes = new QButtonGroup(this);
    const auto add = [&](QToolButton* button, const char* name, const QString& text, const QString& tip, Mode mode) {
      button->setObjectName(QLatin1String(name));
      button->setText(text);
      button->setToolTip(tip);
      button->setCheckable(true);
      modes->addButton(button);
      connect(button, &QToolButton::clicked, this, [this, mode] { setMode(mode); });
    };
    add(side_by_side_, "compareSideBySide", tr("Side by side"), tr("Both results, seen from the same side"),
        Mode::SideBySide);
    add(arrows_, "compareArrows", tr("Arrows"), tr("The result of now, with an arrow from where each cell was"),
        Mode::Arrows);
    side_by_side_->setChecked(true);
    slider_->setRange(0, static_cast<int>(kFactors.size()) - 1);
    slider_->setPageStep(3);
    slider_->setMinimumWidth(24 * fontMetrics().averageCharWidth());
    connect(slider_, &QSlider::valueChanged, this, [this](int step) {
      now_->setShiftFactor(kFactors.at(static_cast<std::size_t>(step)));
      showFactor();
    });
    auto* row = spaced(new QHBoxLayout(enlarged_), {8, 0, 0, 0});
    addWidgets(row, {new QLabel(tr("Arrows enlarged")), slider_, factor_label_});
    auto* head = new FlowLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{labelFor(source_, tr("Before:")), source_, side_by_side_,
                                                           arrows_, enlarged_}) {
      head->addWidget(widget);
    }
    layout->addLayout(head);
    enlarged_->hide();
  }

  void showContent() {
    const bool with_arrows = mode_ == Mode::Arrows;
    before_pane_->setVisible(!with_arrows);
    enlarged_->setVisible(with_arrows);
    (with_arrows ? arrows_ : side_by_side_)->setChecked(true);
    before_->setReconstruction(with_arrows ? nullptr : content_.before);
    PatchOverlays overlays;
    if (with_arrows) overlays.comparison = content_.comparison;
    now_->setOverlays(overlays);
    now_->setReconstruction(content_.now);
    summary_->setText(inWords());
    showFactor();
  }

  void showFactor() {
    const std::optional<double> shown = now_->shiftFactor();
    slider_->setEnabled(shown.has_value());
    factor_label_->setText(shown ? tr("%1 times").arg(QLocale().toString(*shown, 'f', 0)) : noValue());
    const QSignalBlocker quiet(slider_);
    if (shown) slider_->setValue(static_cast<int>(std::ranges::lower_bound(kFactors, *shown - 0.5) - kFactors.begin()));
  }

  [[nodiscard]] QString inWords() const {
    if (!content_.before || !content_.comparison) return {};
    const ComparisonSummary all = summariseComparisons(*content_.comparison);
    const CellDifference* farthest = farthestMoved(*content_.comparison);
    if (all.cells == 0 || farthest == nullptr) return tr("The two have no cells in common.");
    return tr("%1 cells in common. Between before and now they lie %2 apart and are turned by %3 (rms, after "
              "the best fit of both); cell %4 has moved most, by %5.")
        .arg(QString::number(all.cells), millimetresText(all.position_rms_m, 2), degreesText(all.orientation_rms_rad),
             QString::number(farthest->cell.value()), millimetresText(farthest->position_m.norm(), 2));
  }

  PatchView* before_;
  PatchView* now_;
  std::unique_ptr<CameraLink> cameras_;
  Content content_;
  Mode mode_ = Mode::SideBySide;
  QComboBox* source_ = named(new QComboBox, "compareSource", tr("What the result of now is compared with"));
  QToolButton* side_by_side_ = new QToolButton;
  QToolButton* arrows_ = new QToolButton;
  QWidget* enlarged_ = new QWidget;
  QSlider* slider_ = named(new QSlider(Qt::Horizontal), "compareFactor", tr("Enlargement of the arrows"));
  QLabel* factor_label_ = named(new QLabel, "compareFactorLabel");
  QWidget* before_pane_ = nullptr;
  QLabel* summary_ = named(new QLabel, "compareSummary");
};

}  // namespace hexoderm
