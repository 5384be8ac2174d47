#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/controls/arrow_keys.h"
#include "widgets/controls/figure_card.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/patch/found_places.h"
#include "widgets/patch/patch_clicks.h"
#include "widgets/patch/patch_marks.h"
#include "widgets/patch/scene_widget.h"
#include "widgets/scene/camera_glide.h"
#include "widgets/scene/patch_scene.h"
#include "widgets/scene/scene_pointing.h"
#include "widgets/words/cell_words.h"
#include "widgets/words/formatting.h"

#include <vtkCommand.h>
#include <vtkRenderer.h>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QObject>
#include <QPoint>
#include <QShortcut>
#include <QTimeLine>
#include <QTimer>
#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// Pointing in the 3D view: what is under the mouse is outlined, with its figures on a card; what is picked is outlined
/// and, if that is wanted, has a card with its figures and neighbours; arrow keys walk from neighbour to neighbour; and
/// the camera goes to what is sought. The scene is drawn anew only where the camera moves.
class PatchPointing : public QObject {
  Q_OBJECT

 public:
  /// `canvas` lies inside `view` and fills it; `render` asks for a picture soon. All but `canvas` must outlive this.
  PatchPointing(QWidget* view, SceneWidget* canvas, PatchScene& scene, Selection* selection,
                std::function<void()> render)
      : view_(view), canvas_(canvas), scene_(scene), selection_(selection), render_(std::move(render)) {
    figure_card_->setAccessibleName(tr("Figures of what is picked"));
    setUpOnce(look_soon_, kLook_ms, this, &PatchPointing::look);
    glide_time_.setUpdateInterval(kGlideFrame_ms);
    glide_time_.setEasingCurve(QEasingCurve::InOutSine);
    connect(&glide_time_, &QTimeLine::valueChanged, this, [this](double share) {
      if (glide_) glide_->moveTo(share);
      render_();
    });
    connect(&glide_time_, &QTimeLine::finished, this, &PatchPointing::stopGlide);
    connect(selection_, &Selection::changed, this, [this] {
      updateMarks();
      updateMetrics();
    });
    connect(selection_, &Selection::sought, this, &PatchPointing::goToPicked);
    connect(figure_card_, &FigureCard::neighborChosen, selection_, &Selection::seekCell);
    connect(figure_card_, &FigureCard::closed, this, [this] { setMetricsShown(false); });
    escape_->setEnabled(false);
    connect(escape_, &QShortcut::activated, this, &PatchPointing::goBack);
    connect(escape_, &QShortcut::activatedAmbiguously, this, &PatchPointing::goBack);
    observer_ = scene_.renderer()->AddObserver(vtkCommand::EndEvent, this, &PatchPointing::afterRender);
    canvas_->installEventFilter(this);
    view_->installEventFilter(this);
    marks_->setGeometry(view_->rect());
    raise();
  }

  ~PatchPointing() override { scene_.renderer()->RemoveObserver(observer_); }

  /// Off: the camera jumps.
  void setAnimated(bool animated) { animated_ = animated; }
  /// What the cells' colours stand for: its value stands on the cards.
  void setColoring(Coloring coloring) {
    coloring_ = coloring;
    refresh();
  }

  /// Only cells can be pointed at, as while distances between them are measured.
  void setOnlyCells(bool only) {
    only_cells_ = only;
    updateEscape();
  }

  /// Kept free for the buttons.
  void setTopMargin(int pixels) {
    top_margin_ = pixels;
    marks_->setTopMargin(pixels);
    placeMetrics();
  }

  /// The cell that an instruction speaks of.
  void setTold(std::optional<CellId> cell) {
    if (std::exchange(told_, cell) != cell) updateMarks();
  }

  /// Must be called when another skin, other figures or other readings are shown.
  void refresh() {
    const SceneContent* content = scene_.content();
    found_ = content != nullptr ? foundPlaces(content->reconstruction->findings, kMaxFound) : std::vector<FoundPlace>();
    updateMarks();
    updateMetrics();
    if (mouse_) hover(std::exchange(hovered_, SceneHit{}));
  }

  /// Picks what is at a position of the canvas, or nothing.
  void pickAt(const QPoint& position) {
    const SceneHit hit = hitAtPosition(position);
    if (hit.cell) {
      selection_->selectCell(*hit.cell);
    } else if (hit.link) {
      selection_->selectLink(hit.link->first, hit.link->second);
    } else {
      selection_->clear();
    }
  }

  /// The cell at a position of the canvas.
  [[nodiscard]] std::optional<CellId> cellAt(const QPoint& position) const {
    const Eigen::Vector2d pixel = canvas_->pixelAt(position);
    return scene_.pick(pixel.x(), pixel.y());
  }

  /// Moves the camera to what is picked.
  void goToPicked() {
    scene_.fitIfDue();
    std::optional<CameraStand> stand;
    if (const auto cell = selection_->cell()) stand = standBefore(scene_, *cell);
    if (const auto link = selection_->link()) stand = standBefore(scene_, link->first, link->second);
    if (!stand) return;
    if (!return_to_) return_to_ = standOf(scene_.renderer()->GetActiveCamera());
    updateEscape();
    glideTo(*stand);
  }

  /// Shows the figures of what is picked, whatever that is, until it is closed.
  void setMetricsShown(bool shown) {
    figures_shown_ = shown;
    updateEscape();
    updateMetrics();
  }

  [[nodiscard]] bool areMetricsShown() const { return figures_shown_; }
  /// There is no view to return to any more: somebody has asked for another one.
  void forgetReturn() {
    stopGlide();
    return_to_.reset();
    updateEscape();
  }

  /// Walks to a neighbour by an arrow key, or shows the figures by Return.
  [[nodiscard]] bool onKey(const QKeyEvent& event) {
    if ((event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier | Qt::ShiftModifier)) != 0) {
      return false;
    }
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
      setMetricsShown(!figures_shown_);
      return true;
    }
    const auto direction = directionOfKey(event.key());
    if (!direction || scene_.content() == nullptr || scene_.content()->layout.cells.empty()) return false;
    walk(*direction);
    return true;
  }

  [[nodiscard]] bool isGliding() const { return glide_time_.state() == QTimeLine::Running; }
  /// What stays in a picture of the view.
  void paintMarks(QPainter& painter) const { marks_->paintLasting(painter); }
  /// The outlines right above the canvas, the cards above everything else in the view.
  void raise() {
    // The outlines belong to the picture, and buttons lie above it.
    marks_->stackUnder(canvas_);
    canvas_->stackUnder(marks_);
    figure_card_->raise();
    hover_card_->raise();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == view_) {
      switch (event->type()) {
        case QEvent::Resize:
          marks_->setGeometry(view_->rect());
          updateMetrics();
          break;
        case QEvent::FocusIn: {
          const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
          marks_->setFocusShown(reason != Qt::MouseFocusReason && reason != Qt::ActiveWindowFocusReason &&
                                reason != Qt::PopupFocusReason);
          break;
        }
        case QEvent::FocusOut:
          marks_->setFocusShown(false);
          break;
        default:
          break;
      }
      return false;
    }
    switch (event->type()) {
      case QEvent::MouseMove: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->buttons() != Qt::NoButton) return false;  // the picture, or the part, is being turned
        mouse_ = mouse->pos();
        if (!look_soon_.isActive()) look_soon_.start();
        break;
      }
      case QEvent::Wheel:
        stopGlide();
        break;
      case QEvent::MouseButtonPress:
        stopGlide();
        [[fallthrough]];
      case QEvent::Leave:
      case QEvent::Hide:
        mouse_.reset();
        look_soon_.stop();
        hover({});
        break;
      case QEvent::MouseButtonDblClick: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() != Qt::LeftButton) break;
        pickAt(mouse->pos());
        goToPicked();
        break;
      }
      default:
        break;
    }
    return false;
  }

 private:
  static constexpr int kLook_ms = 20;
  static constexpr int kGlideFrame_ms = 30;
  static constexpr int kGlide_ms = 400;
  static constexpr double kSlack_px = 6;
  static constexpr int kCardMargin = 10;
  /// Where more is wrong, the list of findings says it better.
  static constexpr std::size_t kMaxFound = 6;
  /// The way of a link without its ends, where the numbers of its cells stand.
  static QPolygonF betweenNumbers(QPolygonF way) {
    constexpr double kCut = 0.55;  // of the way from the centre to the port
    if (way.size() < 3) return way;
    way.front() += kCut * (way[1] - way.front());
    way.back() += kCut * (way[way.size() - 2] - way.back());
    return way;
  }

  /// What a card says.
  struct Figures {
    QString text;
    QString value;
    std::vector<FigureCard::Neighbor> neighbors;
    /// The first line alone, for a card in a small view.
    [[nodiscard]] QString title() const { return text.section(QStringLiteral("<br>"), 0, 0); }
  };

  /// There is something to come back from.
  void updateEscape() { escape_->setEnabled(!only_cells_ && (return_to_ || figures_shown_)); }
  void afterRender() {
    updateMarks();
    placeMetrics();
    if (mouse_ && !look_soon_.isActive()) look_soon_.start();
  }

  /// The mouse rests, or has moved, or the scene has moved under it.
  void look() {
    if (mouse_) hover(hitAtPosition(*mouse_));
  }

  void hover(const SceneHit& hit) {
    if (hit == hovered_) {
      constexpr int kClose_px = 8;
      const QRect near = hover_card_->geometry().adjusted(-kClose_px, -kClose_px, kClose_px, kClose_px);
      if (mouse_ && hover_card_->isVisible() && near.contains(*mouse_)) placeHoverCard();
      return;
    }
    hovered_ = hit;
    updateMarks();
    placeHoverCard();
  }

  void placeHoverCard() {
    // What has its card already needs no other.
    const bool is_kept = figure_card_->isVisible() && hovered_ == picked();
    if (hovered_.isNothing() || !mouse_ || is_kept) {
      hover_card_->hide();
      return;
    }
    const Figures figures = figuresOf(hovered_);
    QRect place;
    for (const QString& text : {figures.text, figures.title()}) {
      hover_card_->setContent(text, figures.value);
      place = placeBeside(*mouse_, hover_card_->sizeFor(view_->size()), view_->rect());
      if (!place.isNull()) break;
    }
    hover_card_->setGeometry(place);
    hover_card_->setVisible(!place.isNull() && !figures.text.isEmpty());
  }

  void updateMarks() {
    PatchMarks::Content content;
    content.found = foundMarks();
    content.picked = markOf(picked());
    // One number beside it is enough.
    const auto is_picked = [this](const FoundPlace& place) {
      return place.at.cell && place.at.cell == selection_->cell();
    };
    if (std::ranges::any_of(found_, is_picked)) content.picked.tag.clear();
    if (mouse_ && hovered_ != picked()) content.hovered = markOf(hovered_);
    if (told_) {
      content.told = markOf({told_, std::nullopt});
      content.told.tag = tr("cell %1").arg(told_->value());
      // One number beside it is enough.
      if (selection_->cell() == told_) content.picked.tag.clear();
    }
    marks_->setContent(content);
  }

  void updateMetrics() {
    const Figures figures = figuresOf(picked());
    view_->setAccessibleDescription(figures.title().remove(QStringLiteral("<b>")).remove(QStringLiteral("</b>")));
    if (!figures_shown_ || figures.text.isEmpty()) {
      figure_card_->hide();
      return;
    }
    figure_card_->setContent(figures.text, figures.value, figures.neighbors);
    if (figure_card_->sizeFor(view_->size()).height() > view_->height() - 2 * kCardMargin) {
      figure_card_->setContent(figures.title(), figures.value, figures.neighbors);
    }
    figure_card_->show();
    placeMetrics();
    placeHoverCard();
  }

  /// On the right, below the buttons, or on the left if it would lie over what it is about, or over the ghost.
  void placeMetrics() {
    if (!figure_card_->isVisible()) return;
    const QSize size = figure_card_->sizeFor(view_->size());
    const int top =
        std::max(kCardMargin, std::min(top_margin_ + kCardMargin, view_->height() - kCardMargin - size.height()));
    const QRect right(QPoint(view_->width() - kCardMargin - size.width(), top), size);
    const QRect left(QPoint(kCardMargin, top), size);
    const QRectF about = marks_->content().picked.line.boundingRect();
    const bool goes_left =
        scene_.showsGhost() || (right.intersects(about.toAlignedRect()) && !left.intersects(about.toAlignedRect()));
    figure_card_->setGeometry(goes_left ? left : right);
  }

  void glideTo(const CameraStand& stand) {
    glide_.emplace(scene_.renderer()->GetActiveCamera(), stand, scene_.moment().up_o);
    glide_time_.stop();
    if (animated_ && canvas_->isVisible()) return glide_time_.start();
    glide_->moveTo(1);
    glide_.reset();
    render_();
  }

  void stopGlide() {
    glide_time_.stop();
    glide_.reset();
  }

  void goBack() {
    setMetricsShown(false);
    if (return_to_) glideTo(*return_to_);
    return_to_.reset();
    updateEscape();
  }

  void walk(const Eigen::Vector2d& direction) {
    scene_.fitIfDue();
    const SceneContent& content = *scene_.content();
    std::optional<CellId> next;
    if (const auto link = selection_->link()) {
      const auto source = seenCell(scene_, link->first.cell);
      const auto target = seenCell(scene_, link->second.cell);
      if (source && target) {
        next = (target->center - source->center).dot(direction) >= 0 ? link->second.cell : link->first.cell;
      }
    } else if (const auto cell = selection_->cell(); cell && content.layout.find(*cell) != nullptr) {
      const auto here = seenCell(scene_, *cell);
      double best = 0.5;  // the cosine of 60 degrees
      for (const LinkEstimate* way : content.links.of(content.layout.index.at(*cell))) {
        const CellId neighbor = neighborAcross(*way, *cell);
        const auto there = seenCell(scene_, neighbor);
        if (!here || !there) continue;
        const double along = (there->center - here->center).normalized().dot(direction);
        if (along <= best) continue;
        best = along;
        next = neighbor;
      }
    } else {
      const auto& cells = content.layout.cells;
      const auto origin = std::ranges::find_if(
          cells, [&](const SceneCell& at) { return at.origin && at.patch == content.layout.largest; });
      next = origin == cells.end() ? cells.front().id : origin->id;
    }
    if (!next) return;
    const auto seen = seenCell(scene_, *next);
    if (seen && seen->is_seen && marks_->rect().contains(toView(seen->center).toPoint())) {
      selection_->selectCell(*next);
    } else {
      selection_->seekCell(*next);
    }
  }

  [[nodiscard]] SceneHit picked() const { return {selection_->cell(), selection_->link()}; }
  [[nodiscard]] SceneHit hitAtPosition(const QPoint& position) {
    if (only_cells_) return {cellAt(position), std::nullopt};
    return hitAt(scene_, canvas_->pixelAt(position), kSlack_px * canvas_->devicePixelRatioF());
  }

  [[nodiscard]] Figures figuresOf(const SceneHit& hit) const {
    Figures figures;
    const SceneContent* content = scene_.content();
    if (content == nullptr) return figures;
    const Reconstruction& result = *content->reconstruction;
    if (hit.link) {
      const LinkEstimate* link = result.findLink(hit.link->first, hit.link->second);
      if (link == nullptr) return figures;
      figures.text = linkToolTip(result, *link);
      for (const CellId cell : {link->source.cell, link->target.cell}) {
        figures.neighbors.push_back({cell, cellToolTip(result, cell)});
      }
    } else if (hit.cell) {
      const auto index = content->layout.index.find(*hit.cell);
      if (index == content->layout.index.end()) return figures;
      const LinksOfCell links = content->links.of(index->second);
      figures.text = cellToolTip(result, *hit.cell, links);
      for (const LinkEstimate* link : links) {
        figures.neighbors.push_back({neighborAcross(*link, *hit.cell), linkToolTip(result, *link)});
      }
      const ColoringRow& row = coloringRow(coloring_);
      if (row.of_cell != nullptr) {
        constexpr int kDecimals = 2;
        const auto value = row.of_cell(content->figures, scene_.readings(), index->second);
        const QString unit = QString::fromUtf8(row.unit);
        const QString gap = unit.isEmpty() || unit == QStringLiteral("°") ? QString() : QStringLiteral("\u00a0");
        figures.value = QStringLiteral("<b>%1: %2</b>")
                            .arg(coloringName(coloring_).toHtmlEscaped(),
                                 value ? figureText(*value, kDecimals) + gap + unit.toHtmlEscaped() : notKnownWord());
      }
    }
    return figures;
  }

  [[nodiscard]] SceneMark markOf(const SceneHit& hit) const {
    SceneMark mark;
    if (hit.cell) {
      const std::optional<SeenCell> seen = seenCell(scene_, *hit.cell);
      if (!seen) return mark;
      for (const Eigen::Vector2d& corner : seen->outline) mark.line << toView(corner);
      mark.hidden = !seen->is_seen;
      const std::vector<CellId> numbered = scene_.labelledCells();
      if (!seen->is_seen || std::ranges::find(numbered, *hit.cell) == numbered.end())
        mark.tag = QString::number(hit.cell->value());
    } else if (hit.link) {
      for (const Eigen::Vector2d& point : seenLink(scene_, hit.link->first, hit.link->second)) {
        mark.line << toView(point);
      }
      mark.closed = false;
    }
    return mark;
  }

  [[nodiscard]] std::vector<SceneMark> foundMarks() const {
    std::vector<SceneMark> marks;
    for (const FoundPlace& place : found_) {
      SceneMark mark = markOf(place.at);
      mark.sign = place.severity;
      if (place.at.link) mark.line = betweenNumbers(mark.line);
      mark.tag = place.at.cell ? QString::number(place.at.cell->value())
                               : QStringLiteral("%1\u2013%2")
                                     .arg(place.at.link->first.cell.value())
                                     .arg(place.at.link->second.cell.value());
      marks.push_back(std::move(mark));
    }
    return marks;
  }

  [[nodiscard]] QPointF toView(const Eigen::Vector2d& pixel) const {
    const double ratio = canvas_->devicePixelRatioF();
    return {pixel.x() / ratio, canvas_->height() - pixel.y() / ratio};
  }

  QWidget* view_;
  SceneWidget* canvas_;
  PatchScene& scene_;
  Selection* selection_;
  std::function<void()> render_;
  PatchMarks* marks_ = new PatchMarks(view_);
  FigureCard* hover_card_ = new FigureCard(FigureCard::Kind::Passing, view_);
  FigureCard* figure_card_ = new FigureCard(FigureCard::Kind::Kept, view_);
  QShortcut* escape_ = new QShortcut(QKeySequence(Qt::Key_Escape), view_);
  unsigned long observer_ = 0;

  Coloring coloring_ = Coloring::LinkQuality;
  bool only_cells_ = false;
  bool figures_shown_ = false;
  int top_margin_ = 0;
  std::optional<CellId> told_;
  std::vector<FoundPlace> found_;  ///< in the result that is shown

  std::optional<QPoint> mouse_;  ///< over the canvas, no button pressed
  SceneHit hovered_;
  QTimer look_soon_;

  bool animated_ = true;
  std::optional<CameraGlide> glide_;
  std::optional<CameraStand> return_to_;
  QTimeLine glide_time_{kGlide_ms};
};

}  // namespace hexoderm
