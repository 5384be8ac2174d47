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
using skinwire::Bytes;
using Socket = asio::local::stream_protocol::socket;

/// A stream that is written to, and its other end.
struct Pair {
  explicit Pair(asio::io_context& io)
      : near(io), far(io), queue(near, [](const auto& error) { ADD_FAILURE() << error.message(); }) {
    asio::local::connect_pair(near, far);
    near.non_blocking(true);
  }
  Socket near;
  Socket far;
  WriteQueue<Socket> queue;
};

// All else that a queue does is for the tests of wires and of the emulator.
TEST(WriteQueue, ForgettingGivesUpWhatWaitsAndLaterPiecesAreWritten) {
  constexpr std::size_t kMuch = 16U << 20U;  // more than any socket takes before somebody reads
  asio::io_context io;
  const auto pair = std::make_shared<Pair>(io);
  pair->queue.forget();  // nothing yet
  pair->queue.push(Bytes(kMuch), pair);
  pair->queue.push({7}, pair);
  io.run_for(std::chrono::milliseconds(20));
  Bytes taken(kMuch + 1 - pair->queue.waitingBytes());
  pair->queue.forget();
  io.restart();
  io.run_for(std::chrono::milliseconds(20));
  EXPECT_EQ(pair->queue.waitingBytes(), 0U);
  pair->queue.push({9}, pair);
  asio::read(pair->far, asio::buffer(taken));
  io.restart();
  io.run();
  Bytes later(1);
  asio::read(pair->far, asio::buffer(later));
  EXPECT_EQ(later, Bytes{9});
}

}  // namespace
}  // namespace hexoderm
