#pragma once

#include <QWidget>

namespace hexoderm {

/// A ring that fills while the part is held, with what to do in its middle: "Hold still", "starts over".
class HoldRing : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString word;
    QString detail;
    double progress = 0;    ///< 0 to 1
    bool captured = false;  ///< a pose was just taken: a full ring with a tick

    friend bool operator==(const Content&, const Content&) = default;
  };

  explicit HoldRing(QWidget* parent = nullptr);

  /// Cheap: may be called 20 times a second.
  void setContent(const Content& content);
  [[nodiscard]] const Content& content() const { return content_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Content content_;
};

}  // namespace hexoderm
