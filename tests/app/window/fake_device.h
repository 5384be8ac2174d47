#pragma once

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace hexoderm {

/// A skin of three cells in a row on a TCP port of this computer, which says what a test wants it to say. Its clock is
/// its own, so that seconds of holding still pass at once.
class FakeDevice {
 public:
  static constexpr int kCells = 3;
  static constexpr double kRate_hz = 250;
  static constexpr qint64 kPeriod_us = 4000;

  FakeDevice() {
    EXPECT_TRUE(server_.listen(QHostAddress::LocalHost));
    // Between what a test lets it send it is alive.
    constexpr int kOften_ms = 150;
    QObject::connect(&alive_, &QTimer::timeout, [this] {
      if (host_ && is_introduced_) say("{\"status\": {}}\n");
    });
    alive_.start(kOften_ms);
  }

  [[nodiscard]] QString address() const { return QStringLiteral("tcp://127.0.0.1:%1").arg(server_.serverPort()); }

  /// Waits for the host, as often as it comes.
  void accept() {
    constexpr int kMilliseconds = 120000;
    ASSERT_TRUE(QTest::qWaitFor([this] { return server_.hasPendingConnections(); }, kMilliseconds));
    host_.reset(server_.nextPendingConnection());
    is_introduced_ = false;
  }
  void introduce(bool can_turn = false) {
    say("{\"hello\": {\"device\": \"forearm\", \"cell_model\": \"hex-bma150\", \"rate_hz\": 250, \"can_turn\": " +
        QByteArray(can_turn ? "true" : "false") +
        "}}\n"
        "{\"topology\": {\"id\": 1, \"cells\": ["
        "{\"id\": 1, \"ports\": [{\"port\": 1, \"cell\": 2, \"cell_port\": 4}]},"
        "{\"id\": 2, \"ports\": [{\"port\": 4, \"cell\": 1, \"cell_port\": 1}, {\"port\": 1, \"cell\": 3, "
        "\"cell_port\": 4}]},"
        "{\"id\": 3, \"ports\": [{\"port\": 4, \"cell\": 2, \"cell_port\": 1}]}]}}\n");
    is_introduced_ = true;
  }
  void say(const QByteArray& bytes) {
    host_->write(bytes);
    host_->flush();
  }
  void fallSilent() { is_introduced_ = false; }
  void hangUp() { host_.reset(); }
  /// No host gets through any more, until it is plugged in again.
  void unplug() {
    port_ = server_.serverPort();
    hangUp();
    server_.close();
  }
  void plugIn() { ASSERT_TRUE(server_.listen(QHostAddress::LocalHost, port_)); }

  /// So many samples are not sent; from the first call on, those that are have numbers.
  void lose(int samples) { sequence_ = sequence_.value_or(0) + samples; }
  /// Readings of so many seconds, with the noise of real ones. `motion`: what a cell reads at a time since the
  /// beginning of these seconds; cells for which it is nothing say nothing.
  using Motion = std::function<Eigen::Vector3d(int cell, double time_s)>;
  void send(double seconds, const Motion& motion) {
    const int ticks = static_cast<int>(seconds * kRate_hz);
    constexpr int kAtOnce = 25;
    for (int begin = 0; begin < ticks; begin += kAtOnce) {
      const int end = std::min(ticks, begin + kAtOnce);
      QByteArray cells;
      QByteArray values;
      for (int cell = 1; cell <= kCells; ++cell) {
        if (motion(cell, begin / kRate_hz).allFinite())
          cells += QByteArray(cells.isEmpty() ? "" : ",") + QByteArray::number(cell);
      }
      for (int tick = begin; tick < end; ++tick) {
        for (int cell = 1; cell <= kCells; ++cell) {
          const Eigen::Vector3d reading = motion(cell, tick / kRate_hz);
          for (int axis = 0; reading.allFinite() && axis < 3; ++axis) {
            values +=
                QByteArray(values.isEmpty() ? "" : ",") + QByteArray::number(reading[axis] + noise_(random_), 'f', 5);
          }
        }
      }
      const QByteArray number = sequence_ ? "\"sequence\": " + QByteArray::number(*sequence_) + ", " : QByteArray();
      if (sequence_) *sequence_ += (end - begin) * (cells.count(',') + 1);
      say("{\"samples\": {" + number + "\"time_us\": " + QByteArray::number(kPeriod_us * tick_) +
          ", \"period_us\": 4000, \"cells\": [" + cells + "], \"acceleration_g\": [" + values + "]}}\n");
      tick_ += end - begin;
    }
  }
  /// Held still with this direction up.
  void hold(double seconds, const Eigen::Vector3d& up) {
    send(seconds, [&](int cell, double /*time_s*/) { return seenBy(cell, up); });
  }
  /// The direction in the frame of a cell: the three lie on a cylinder.
  static Eigen::Vector3d seenBy(int cell, const Eigen::Vector3d& up) {
    const double bend = 0.25 * (cell - 2);
    return Eigen::AngleAxisd(bend, Eigen::Vector3d::UnitY()) * up.normalized();
  }
  static Eigen::Vector3d nothing() { return Eigen::Vector3d::Constant(std::nan("")); }

 private:
  QTcpServer server_;
  std::unique_ptr<QTcpSocket> host_;
  QTimer alive_;
  bool is_introduced_ = false;
  quint16 port_ = 0;
  qint64 tick_ = 1000;
  std::optional<qint64> sequence_;
  std::mt19937 random_{7};
  std::normal_distribution<double> noise_{0, 0.008};
};

}  // namespace hexoderm
