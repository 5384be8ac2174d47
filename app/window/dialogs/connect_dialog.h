#pragma once

#include "app/window/session/session_controller.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace hexoderm {

/// Asks which skin to connect to and where its poses are kept. Emits the request when it is accepted; the receiver
/// connects. Remembers the last choice.
class ConnectDialog : public QDialog {
  Q_OBJECT

 public:
  /// `folder`: where new sessions go unless another is chosen. `open_session`: name of the session that poses can be
  /// added to; empty if there is none.
  ConnectDialog(const QString& folder, const QString& open_session, QWidget* parent = nullptr);

  [[nodiscard]] ConnectRequest request() const;

 signals:
  void connectRequested(const hexoderm::ConnectRequest& request);

 public slots:
  void accept() override;

 private:
  void chooseKind();
  void chooseRecording();
  void choosePath();
  void check();
  [[nodiscard]] QString problemWithPath() const;

  QComboBox* kind_;
  QComboBox* address_;
  QPushButton* browse_recording_;
  QLabel* hint_;
  QCheckBox* continue_;
  QLineEdit* path_;
  QPushButton* browse_path_;
  QLabel* note_;
  QPushButton* connect_;
};

}  // namespace hexoderm
