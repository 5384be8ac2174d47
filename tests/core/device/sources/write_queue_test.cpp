#include "hexoderm/device/sources/write_queue.h"

#include "tests/support/testing.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/connect_pair.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>

#include <chrono>

namespace hexoderm {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using skinwire::Bytes;
using Socket = asio::local::stream_protocol::socket;

/// More than any socket takes before somebody reads.
constexpr std::size_t kMuch = 16U << 20U;

/// A stream that is written to, and its other end.
struct Pair {
  explicit Pair(asio::io_context& io)
      : near(io), far(io), queue(near, [this](const error_code& error) { errors.push_back(error); }) {
    asio::local::connect_pair(near, far);
    near.non_blocking(true);
  }
  Socket near;
  Socket far;
  std::vector<error_code> errors;
  WriteQueue<Socket> queue;
};

class WriteQueueTest : public ::testing::Test {
 protected:
  Bytes read(std::size_t size) {
    Bytes bytes(size);
    bool is_read = false;
    asio::async_read(pair_->far, asio::buffer(bytes), [&](const error_code& error, std::size_t) {
      EXPECT_FALSE(error) << error.message();
      is_read = true;
    });
    io_.restart();
    while (!is_read && io_.run_one() > 0) {
    }
    EXPECT_TRUE(is_read);
    return bytes;
  }

  asio::io_context io_;
  std::shared_ptr<Pair> pair_ = std::make_shared<Pair>(io_);
};

TEST_F(WriteQueueTest, PiecesArriveInOrderAlsoWhereTheStreamTakesThemInParts) {
  Bytes much(kMuch);
  for (std::size_t k = 0; k < much.size(); ++k) much[k] = static_cast<std::uint8_t>(k * k >> 8U);
  pair_->queue.push({1, 2}, pair_);
  pair_->queue.push({}, pair_);
  pair_->queue.push(much, pair_);
  pair_->queue.push({3}, pair_);
  EXPECT_EQ(pair_->queue.waitingBytes(), kMuch + 3);
  EXPECT_EQ(read(2), (Bytes{1, 2}));
  EXPECT_EQ(read(kMuch), much);
  EXPECT_EQ(read(1), (Bytes{3}));
  io_.restart();
  io_.run();
  EXPECT_EQ(pair_->queue.waitingBytes(), 0U);
  EXPECT_FALSE(pair_->queue.isStalled(WriteQueue<Socket>::Clock::duration::zero()));
}

TEST_F(WriteQueueTest, IsStalledWhileNobodyReads) {
  pair_->queue.push(Bytes(kMuch), pair_);
  io_.run_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(pair_->queue.isStalled(std::chrono::milliseconds(1)));
  EXPECT_FALSE(pair_->queue.isStalled(std::chrono::hours(1)));
  EXPECT_GT(pair_->queue.waitingBytes(), 0U);
}

TEST_F(WriteQueueTest, ForgettingGivesUpWhatWaitsAndLaterPiecesAreWritten) {
  pair_->queue.forget();  // nothing yet
  pair_->queue.push(Bytes(kMuch), pair_);
  pair_->queue.push({7}, pair_);
  io_.run_for(std::chrono::milliseconds(20));
  const std::size_t taken = kMuch + 1 - pair_->queue.waitingBytes();
  pair_->queue.forget();
  io_.restart();
  io_.run_for(std::chrono::milliseconds(20));
  EXPECT_EQ(pair_->queue.waitingBytes(), 0U);
  EXPECT_TRUE(pair_->errors.empty());
  pair_->queue.push({9}, pair_);
  read(taken);
  EXPECT_EQ(read(1), (Bytes{9}));
}

TEST_F(WriteQueueTest, AnErrorIsToldOnceAndNothingIsWrittenAfterwards) {
  pair_->far.close();
  pair_->queue.push({1}, pair_);
  pair_->queue.push({2}, pair_);
  io_.run();
  pair_->queue.push({3}, pair_);
  io_.restart();
  io_.run();
  ASSERT_EQ(pair_->errors.size(), 1U);
  EXPECT_EQ(pair_->errors.front(), asio::error::broken_pipe);
}

TEST_F(WriteQueueTest, KeepsItsOwnerUntilTheChannelHasAnswered) {
  const std::weak_ptr<Pair> weak = pair_;
  pair_->queue.push({1}, pair_);
  pair_.reset();
  EXPECT_FALSE(weak.expired());
  io_.run();
  EXPECT_TRUE(weak.expired());
}

}  // namespace
}  // namespace hexoderm
