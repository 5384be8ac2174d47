#pragma once

#include "app/window/presenters/presenter.h"

#include <QString>
#include <cstdint>

namespace hexoderm {

class FilePresenter;
struct ConnectRequest;

/// Shows the connection to a skin, from the dialog that asks for its address to the words on what it captured.
class ConnectionPresenter : public Presenter {
  Q_OBJECT

 public:
  ConnectionPresenter(const WindowParts& parts, FilePresenter& files);

  /// Asks first if poses would be lost.
  void connectTo(const ConnectRequest& request);
  /// Shows where the connection stands. Cheap: may be called 20 times a second.
  void refresh() override;

 private:
  void showDialog();
  void showCaptured(const QString& text, bool remarkable);
  void showOffences();

  FilePresenter& files_;
  std::size_t offences_shown_ = 0;       ///< of those of the running source
  std::uint64_t late_frames_shown_ = 0;  ///< of the recorder
};

}  // namespace hexoderm
