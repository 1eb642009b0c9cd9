// A server of frames and its clients, good and bad, over the loopback.

#include "murosimf/control/wire/frame_server.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "murosimf/control/wire/frame_client.h"

namespace murosimf::testing {
namespace {

using namespace std::chrono_literals;

FrameBytes bytes(const std::string& text) { return {text.begin(), text.end()}; }
std::chrono::steady_clock::time_point soon() { return std::chrono::steady_clock::now() + 5s; }

/// A port with one channel.
struct OnePort {
  explicit OnePort(const ChannelLimits& limits = {}, const std::vector<std::string>& allowed = {"127.0.0.1"})
      : channel(std::make_shared<FrameChannel>(limits)) {
    FramePort settings;
    settings.allowed = allowed;
    settings.welcome = "hello", settings.refusal = "go away";
    settings.free_channel = [c = channel] { return c->isConnected() ? nullptr : c; };
    port = server.listen(std::move(settings));
  }
  FrameClient client() const { return {"127.0.0.1", port, 5}; }
  FrameClient welcomed() const {
    FrameClient client = this->client();
    std::array<std::uint8_t, 5> word{};
    EXPECT_TRUE(client.readRaw(word.data(), word.size()));
    EXPECT_EQ(std::string(word.begin(), word.end()), "hello");
    return client;
  }
  /// The next frame of the client.
  std::string next() const { return channel->waitForFrame(soon()) ? text(*channel->receive()) : "nothing"; }
  static std::string text(const FrameBytes& frame) { return {frame.begin(), frame.end()}; }

  std::shared_ptr<FrameChannel> channel;
  FrameServer server;
  int port = 0;
};

TEST(FrameServer, FramesGoBothWays) {
  const OnePort port;
  FrameClient client = port.welcomed();
  client.send(bytes("ball"));
  EXPECT_EQ(port.next(), "ball");
  port.channel->send(bytes("goal"));
  FrameBytes answer;
  ASSERT_TRUE(client.receive(answer, 100));
  EXPECT_EQ(OnePort::text(answer), "goal");
  while (port.channel->counts().sent < 1) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(port.channel->counts().bytes_sent, 4U);
}

TEST(FrameServer, HostsThatAreNotAllowedAreRefused) {
  const OnePort port({}, {"192.0.2.7"});
  FrameClient client = port.client();
  std::array<std::uint8_t, 7> word{};
  ASSERT_TRUE(client.readRaw(word.data(), word.size()));
  EXPECT_EQ(std::string(word.begin(), word.end()), "go away");
  EXPECT_FALSE(client.readRaw(word.data(), 1));
  EXPECT_EQ(port.server.refusedClients(), 1);
  EXPECT_FALSE(port.channel->isConnected());
}

TEST(FrameServer, SecondClientWaitsUntilTheFirstHasGone) {
  const OnePort port;
  auto first = std::make_unique<FrameClient>(port.welcomed());
  FrameClient second = port.client();
  second.send(bytes("second"));
  first->send(bytes("first"));
  EXPECT_EQ(port.next(), "first");
  EXPECT_FALSE(port.channel->waitForFrame(std::chrono::steady_clock::now() + 100ms));
  first.reset();
  while (port.channel->connection() < 2) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(port.next(), "second");
}

TEST(FrameServer, ClientThatAnnouncesTooMuchIsCutOff) {
  const OnePort port;
  FrameClient client = port.welcomed();
  const std::array<std::uint8_t, 4> header{0xFF, 0xFF, 0xFF, 0xFF};
  client.sendRaw(header.data(), header.size());
  std::uint8_t byte = 0;
  EXPECT_FALSE(client.readRaw(&byte, 1));
  EXPECT_EQ(port.channel->counts().last_end, "announced a frame of 4294967295 bytes, expected at most 65536");
}

TEST(FrameServer, OfAClientThatDoesNotReadTheOldestFramesAreDropped) {
  ChannelLimits limits;
  limits.most_sent = 8;
  const OnePort port(limits);
  FrameClient client = port.welcomed();
  const FrameBytes large(1 << 20);
  for (int i = 0; i < 200; ++i) {
    port.channel->send(FrameBytes(large));
    if (i % 20 == 0) std::this_thread::sleep_for(1ms);
  }
  port.channel->send(bytes("newest"));
  EXPECT_GT(port.channel->counts().dropped, 100);
  FrameBytes frame;
  do {
    ASSERT_TRUE(client.receive(frame, 2 << 20));
    ASSERT_TRUE(frame.size() == large.size() || OnePort::text(frame) == "newest") << "a frame was torn";
  } while (frame.size() == large.size());
}

TEST(FrameServer, ClientThatFloodsIsNotReadFasterThanItsFramesAreTaken) {
  ChannelLimits limits;
  limits.most_received = 4;
  const OnePort port(limits);
  FrameClient client = port.welcomed();
  constexpr int kFrames = 5000;
  std::thread flood([&] {
    for (int i = 0; i < kFrames; ++i) client.send(bytes(std::to_string(i) + std::string(1000, '.')));
  });
  for (int i = 0; i < kFrames; ++i) {
    const std::string frame = port.next();
    ASSERT_EQ(frame.substr(0, frame.find('.')), std::to_string(i)) << "nothing is lost, nothing overtakes";
  }
  flood.join();
}

TEST(FrameServer, AThousandConnectionsOneAfterAnother) {
  const OnePort port;
  for (int i = 1; i <= 1000; ++i) {
    FrameClient client = port.welcomed();
    client.send(bytes("x"));
    if (i % 100 == 0) {
      EXPECT_EQ(port.next(), "x");
    }
  }
  EXPECT_GE(port.channel->connection(), 1000);
}

TEST(FrameServer, OneClientThatDoesNothingHindersNoOther) {
  FrameServer server;
  const auto makePort = [&](const std::shared_ptr<FrameChannel>& channel) {
    FramePort settings;
    settings.free_channel = [channel] { return channel->isConnected() ? nullptr : channel; };
    return server.listen(std::move(settings));
  };
  const auto idle = std::make_shared<FrameChannel>(), busy = std::make_shared<FrameChannel>();
  const FrameClient sleeper("127.0.0.1", makePort(idle), 5);
  FrameClient talker("127.0.0.1", makePort(busy), 5);
  ASSERT_TRUE(idle->waitForClient(soon()) && busy->waitForClient(soon()));
  for (int i = 0; i < 100; ++i) {
    idle->send(FrameBytes(1 << 20));
    talker.send(bytes("ping"));
    ASSERT_TRUE(busy->waitForFrame(soon()));
    EXPECT_EQ(OnePort::text(*busy->receive()), "ping");
  }
}

TEST(FrameServer, PortInUseIsTold) {
  const OnePort port;
  FrameServer other;
  FramePort settings;
  settings.port = port.port;
  settings.free_channel = [] { return nullptr; };
  try {
    other.listen(std::move(settings));
    FAIL() << "two listen on one port";
  } catch (const std::system_error& problem) {
    EXPECT_EQ(std::string(problem.what()),
              "cannot listen on 127.0.0.1:" + std::to_string(port.port) + ": Address already in use");
  }
}

TEST(FrameServer, UnknownHostIsTold) {
  FrameServer server;
  FramePort settings;
  settings.allowed = {"no.such.host.invalid"};
  settings.free_channel = [] { return nullptr; };
  EXPECT_THROW(server.listen(std::move(settings)), std::invalid_argument);
}

}  // namespace
}  // namespace murosimf::testing
