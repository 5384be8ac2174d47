#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/coloring/coloring.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/palette.h"
#include "widgets/tables/reconstruction_table.h"
#include "widgets/tables/row_picking.h"
#include "widgets/tables/sorted_table.h"
#include "widgets/tables/table_cells.h"
#include "widgets/verify/residual_plots.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// Links x poses: how badly each link fits each pose. One row a link, as LinkTable has them; the first column is the
/// link's rms over its poses, then one column a pose. Row headers name the links.
class ResidualTable : public LinkRowTable {
  Q_OBJECT

 public:
  using LinkRowTable::LinkRowTable;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation == Qt::Horizontal) return LinkRowTable::headerData(section, orientation, role);
    if (section < 0 || section >= rowCount()) return {};
    switch (role) {
      case Qt::DisplayRole:
      case kRawRole:
        return shortLinkName(linkAt(section));
      case kUnitRole:
        return tr("Link");
      case Qt::ToolTipRole:
        return linkToolTip(*reconstruction(), linkAt(section));
      case Qt::TextAlignmentRole:
        return alignment(true);
      default:
        return {};
    }
  }

  /// none for the first column
  [[nodiscard]] std::optional<PoseId> poseAt(int column) const {
    if (column < 1 || column >= columnCount()) return std::nullopt;
    return reconstruction()->poses[static_cast<std::size_t>(column - 1)].pose;
  }

 protected:
  void rebuild() override {
    LinkRowTable::rebuild();
    setColumns({});
    if (!reconstruction()) return;
    std::vector<Column> columns;
    // `spoken`: with a place for the link and one for the residual.
    const auto add = [&](const QString& name, const QString& explanation, const QString& spoken, auto residual) {
      columns.push_back({.name = name, .unit = QStringLiteral("deg"), .explanation = explanation, .decimals = 2});
      columns.back().value = [this, residual](int row) { return rawDegrees(residual(linkAt(row))); };
      columns.back().spoken = [this, residual, spoken](int row) {
        return spoken.arg(longLinkName(linkAt(row)), degreesText(residual(linkAt(row))));
      };
    };
    add(tr("All"), tr("Rms over the poses, degrees"), tr("%1, all poses: %2"),
        [](const LinkEstimate& link) { return link.knownResidual(); });
    for (const PoseSummary& pose : reconstruction()->poses) {
      const auto number = pose.pose.value();
      const std::size_t place = columns.size() - 1;
      add(tr("Pose %1").arg(number),
          pose.enabled ? tr("Pose %1 %2, degrees").arg(number).arg(words(pose.label)).simplified()
                       : tr("Pose %1 is disabled: it is kept, but not used.").arg(number),
          tr("%1, pose %2: %3").arg(QStringLiteral("%1"), QString::number(number), QStringLiteral("%2")),
          [place](const LinkEstimate& link) {
            return place < link.pose_residual_rad.size() ? link.pose_residual_rad[place] : std::nullopt;
          });
    }
    setColumns(std::move(columns));
  }

  [[nodiscard]] QVariant ofRow(int row, int role) const override {
    return role == Qt::ToolTipRole ? linkToolTip(*reconstruction(), linkAt(row)) : QVariant();
  }
};

/// The end of the scale is the same as in the graph and in the 3D view.
inline double residualScaleEnd_deg() { return coloringRow(Coloring::Residual).range->high; }
/// Viridis for a residual, on the scale that all views share, and what can be read on it.
inline QColor residualColor(double residual_deg) { return viridis(residual_deg / residualScaleEnd_deg()); }

/// Residuals of each link in each pose, as a matrix of numbers and colours, or as plots. Picking a cell of the matrix
/// picks the link, and its pose by posePicked(); a link that is picked elsewhere is picked here.
class ResidualView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit ResidualView(Selection* selection, QWidget* parent = nullptr) : QWidget(parent), selection_(selection) {
    matrix_->setModel(sorted_);
    matrix_->setItemDelegate(new ResidualMatrixDelegate(matrix_));
    matrix_->setSelectionMode(QAbstractItemView::SingleSelection);
    dressTable(matrix_);
    matrix_->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    matrix_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    matrix_->horizontalHeader()->setHighlightSections(true);
    // In the order of the links until a header is clicked: "All" brings the worst to the top.
    SortedTable::enableIn(matrix_);
    addWidgets(pages_, {matrix_, plots_});

    auto* layout = spaced(new QVBoxLayout(this), {0, 0, 0, 0}, 0);
    layout->addWidget(buildHeader());
    layout->addWidget(pages_, 1);

    onPicked(matrix_, this, [this](const QModelIndex& picked) { pickCurrent(picked); });
    connect(matrix_, &QTableView::clicked, this, &ResidualView::pickCurrent);
    connect(plots_, &ResidualPlots::posePicked, this, &ResidualView::posePicked);
    connect(selection_, &Selection::changed, this, &ResidualView::showPicked);
    fitColumns();
    showMatrix();
  }

  void setReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction) {
    following_ = true;
    table_->setReconstruction(reconstruction);
    plots_->setReconstruction(reconstruction);
    following_ = false;
    showPicked();
  }

  /// The matrix, for the actions on tables.
  [[nodiscard]] QTableView* matrix() const { return matrix_; }

 public slots:
  void showMatrix() {
    matrix_button_->setChecked(true);
    pages_->setCurrentWidget(matrix_);
    legend_->show();
  }

  void showPlots() {
    plots_button_->setChecked(true);
    pages_->setCurrentWidget(plots_);
    legend_->hide();
  }

 signals:
  void posePicked(hexoderm::PoseId pose);

 protected:
  void changeEvent(QEvent* event) override {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitColumns();
  }

 private:
  QWidget* buildHeader() {
    auto* header = new QWidget;
    auto* row = spaced(new QHBoxLayout(header), {6, 2, 8, 2});
    auto* group = new QButtonGroup(this);
    matrix_button_ = addChoice(group, row, "residualMatrixButton", tr("Matrix"));
    matrix_button_->setToolTip(tr("Every link in every pose, as numbers and colours"));
    plots_button_ = addChoice(group, row, "residualPlotsButton", tr("Plots"));
    plots_button_->setToolTip(tr("Residuals by pose, by link, and beside what was predicted"));
    connect(matrix_button_, &QToolButton::clicked, this, &ResidualView::showMatrix);
    connect(plots_button_, &QToolButton::clicked, this, &ResidualView::showPlots);
    row->addStretch();
    row->addWidget(legend_);
    return header;
  }

  void pickCurrent(const QModelIndex& current) {
    if (following_ || !current.isValid()) return;
    const QModelIndex source = sorted_->mapToSource(current);
    const LinkEstimate& link = table_->linkAt(source.row());
    following_ = true;
    selection_->selectLink(link.source, link.target);
    following_ = false;
    if (const std::optional<PoseId> pose = table_->poseAt(source.column())) emit posePicked(*pose);
  }

  void showPicked() {
    if (following_) return;
    const std::optional<Selection::Link> link = selection_->link();
    const int row = link ? table_->rowOf(link->first, link->second) : -1;
    following_ = true;
    if (row < 0) {
      matrix_->clearSelection();
    } else {
      const int column = std::max(0, matrix_->currentIndex().column());
      matrix_->setCurrentIndex(sorted_->mapFromSource(table_->index(row, column)));
    }
    following_ = false;
  }

  void fitColumns() {
    // All alike, and wide enough for a heading: measuring a thousand columns takes too long.
    ensurePolished();
    const QFontMetrics metrics = fontMetrics();
    matrix_->horizontalHeader()->setDefaultSectionSize(metrics.horizontalAdvance(tr("Pose %1").arg(1000)) + 22);
    matrix_->verticalHeader()->setDefaultSectionSize(metrics.height() + 6);
  }

  Selection* selection_;
  ResidualTable* table_ = new ResidualTable(this);
  SortedTable* sorted_ = new SortedTable(table_, this);
  QTableView* matrix_ = named(new QTableView, "residualMatrix", tr("Residuals per link and pose"));
  ResidualPlots* plots_ = new ResidualPlots(selection_);
  QStackedWidget* pages_ = new QStackedWidget;
  QToolButton* matrix_button_ = nullptr;
  QToolButton* plots_button_ = nullptr;
  QWidget* legend_ = makeLegend();
  bool following_ = false;  ///< the matrix is being moved to what was picked elsewhere

  /// Paints the cells itself: a thousand columns leave no time for a style sheet.
  class ResidualMatrixDelegate : public QStyledItemDelegate {
   public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
      const Colors& colors = Colors::of(option.palette);
      const QVariant residual = index.data(kRawRole);
      const QRect cell = option.rect.adjusted(0, 0, -1, -1);
      QColor text = colors.text_muted;
      if (residual.isValid()) {
        const QColor ground = residualColor(residual.toDouble());
        painter->fillRect(cell, ground);
        text = textOn(ground);
      }
      painter->setPen(text);
      painter->setFont(option.font);
      painter->drawText(cell.adjusted(2, 0, -5, 0), Qt::AlignRight | Qt::AlignVCenter,
                        index.data(Qt::DisplayRole).toString());
      if (!(option.state & QStyle::State_Selected)) return;
      // Seen on every colour: the outline of what is picked, with one of the ground inside of it.
      painter->setPen(QPen(colors.selection, 2));
      painter->drawRect(cell.adjusted(1, 1, -1, -1));
      painter->setPen(QPen(colors.panel, 1));
      painter->drawRect(cell.adjusted(2, 2, -3, -3));
    }
  };

  /// The colours of the matrix, painted as finely as the screen that they are on shows them.
  class ColorBar : public QWidget {
   public:
    [[nodiscard]] QSize sizeHint() const override { return {96, fontMetrics().height() / 2}; }

   protected:
    void paintEvent(QPaintEvent* /*event*/) override {
      QPainter painter(this);
      const double pixel = 1 / devicePixelRatioF();
      for (double x = 0; x < width(); x += pixel) {
        painter.fillRect(QRectF(x, 0, pixel, height()), viridis(x / (width() - pixel)));
      }
    }
  };

  /// The colours with what they mean.
  static QWidget* makeLegend() {
    auto* legend = new QWidget;
    legend->setAccessibleName(
        ResidualView::tr("Colours: residual from 0 to %1 degrees and more").arg(residualScaleEnd_deg()));
    legend->setToolTip(legend->accessibleName());
    auto* bar = new ColorBar;
    bar->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    auto* left = new QLabel(ResidualView::tr("Residual 0°"));
    auto* right = new QLabel(ResidualView::tr("≥ %1°").arg(residualScaleEnd_deg()));
    for (QLabel* label : {left, right}) label->setProperty("muted", true);
    addWidgets(spaced(new QHBoxLayout(legend), {0, 0, 0, 0}, 6), {left, bar, right});
    return legend;
  }
};

}  // namespace hexoderm
