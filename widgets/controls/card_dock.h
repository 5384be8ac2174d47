#pragma once

#include <QDockWidget>

class QLabel;

namespace hexoderm {

class ElidedLabel;

/// A panel that can be moved: a card with a small heading on the left and a remark on the right.
class CardDock : public QDockWidget {
  Q_OBJECT

 public:
  /// `object_name` names the dock where the layout is remembered. Takes over `content`.
  CardDock(const QString& heading, const QString& object_name, QWidget* content, QWidget* parent = nullptr);

  /// Sets the heading, for docks whose content changes.
  void setHeading(const QString& heading);
  /// Never widens the dock: it ends in dots where it finds no room.
  void setRemark(const QString& remark);
  /// Shows `widget`, for example tabs, in the place of the heading.
  void setHead(QWidget* widget);

 private:
  QLabel* title_;
  ElidedLabel* remark_;
};

}  // namespace hexoderm
