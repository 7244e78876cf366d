#include "frames/sequence/farm/forked_crew.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/frames/program.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

std::string text_of(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

/// Does what the parcel says: "fail", "die", "die once FILE"; anything else becomes a picture of one pixel a
/// letter.
class Actor final : public FrameMaker {
 public:
  Made make(const std::string& file, std::span<const std::uint8_t> parcel,
            std::optional<std::uint64_t> /*kept*/) override {
    const std::string text = text_of(parcel);
    if (text == "fail") throw std::runtime_error("no luck with " + file);
    if (text == "die") ::raise(SIGKILL);
    if (text.starts_with("die once ")) die_once(text.substr(9));
    if (text == "slow") std::this_thread::sleep_for(std::chrono::milliseconds(30));
    image_ = make_image(static_cast<int>(text.size()), 1);
    std::ranges::copy(text, image_.rgba.begin());
    return {text.size(), &image_};
  }

 private:
  static void die_once(const std::string& path) {
    if (std::filesystem::exists(path)) return;
    std::ofstream{path} << "x";
    ::raise(SIGKILL);
  }

  Image image_;
};

std::unique_ptr<FrameMaker> start() { return std::make_unique<Actor>(); }

FrameOrder order(std::uint32_t index, const std::string& text) {
  FrameOrder order;
  order.record.index = index;
  order.record.file = "frame" + std::to_string(index);
  order.parcel = {text.begin(), text.end()};
  order.wants_image = index % 2 == 0;
  return order;
}

class ForkedCrewTest : public ::testing::Test {
 protected:
  ForkedCrew crew(int workers) {
    return {workers, 4096, start, [this](const FrameRecord& record, const Image& image) {
              delivered_.push_back(record.index);
              hashes_.push_back(record.pixel_hash);
              if (!image.rgba.empty()) letters_.push_back(text_of(image.rgba).substr(0, record.pixel_hash));
            }};
  }

  std::vector<std::uint32_t> delivered_;
  std::vector<std::uint64_t> hashes_;
  std::vector<std::string> letters_;
};

TEST_F(ForkedCrewTest, DeliversInOrderWithThePixelsThatAreWanted) {
  ForkedCrew crew = this->crew(3);
  for (std::uint32_t i = 0; i < 40; ++i) crew.add(order(i, i % 7 == 0 ? "slow" : std::to_string(i)));
  crew.finish();
  ASSERT_EQ(delivered_.size(), 40U);
  for (std::uint32_t i = 0; i < 40; ++i) {
    EXPECT_EQ(delivered_[i], i);
    const std::string text = i % 7 == 0 ? "slow" : std::to_string(i);
    EXPECT_EQ(hashes_[i], text.size());
    if (i % 2 == 0) {
      EXPECT_EQ(letters_[i / 2], text);
    }
  }
}

TEST_F(ForkedCrewTest, ErrorComesOutAndWhatWasFinishedIsDelivered) {
  ForkedCrew crew = this->crew(2);
  crew.add(order(0, "a"));
  crew.add(order(1, "fail"));
  try {  // a call of `add` may throw it, too
    crew.add(order(2, "b"));
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no luck with frame1"));
  }
  try {
    crew.finish();
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no luck with frame1"));
  }
  EXPECT_EQ(delivered_.front(), 0U);
  EXPECT_THAT(delivered_, ::testing::Not(::testing::Contains(1U)));
}

TEST_F(ForkedCrewTest, FramesOfOneThatDiesAreMadeByTheOthers) {
  const test::TemporaryFolder folder;
  ForkedCrew crew = this->crew(2);
  for (std::uint32_t i = 0; i < 20; ++i)
    crew.add(order(i, i == 5 ? "die once " + (folder.path() / "flag").string() : "x"));
  crew.finish();
  EXPECT_EQ(delivered_.size(), 20U);
}

TEST_F(ForkedCrewTest, AFrameThatKillsIsGivenUp) {
  ForkedCrew crew = this->crew(3);
  try {  // a call of `add` throws it, too
    for (std::uint32_t i = 0; i < 3; ++i) crew.add(order(i, i == 1 ? "die" : "x"));
    crew.finish();
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("frame1"));
    EXPECT_THAT(error.what(), HasSubstr("signal 9"));
  }
  EXPECT_THAT(delivered_, ::testing::Not(::testing::Contains(1U)));
}

TEST(ForkedCrew, HoldsNoMoreFramesThanItMay) {
  std::atomic<bool> open = false;
  ForkedCrew crew(2, 4096, start, [&](const FrameRecord& /*record*/, const Image& /*image*/) {
    while (!open) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  std::atomic<int> added = 0;
  std::thread adder([&] {
    for (std::uint32_t i = 0; i < 50; ++i, ++added) crew.add(order(i, "x"));
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LE(added, 8) << "six on their way, one delivered, one on its way in";
  open = true;
  adder.join();
  crew.finish();
}

TEST(ForkedCrew, GoesAwayUnfinished) {
  std::vector<std::uint32_t> delivered;
  {
    ForkedCrew crew(2, 4096, start, [&](const FrameRecord& record, const Image& /*image*/) {
      delivered.push_back(record.index);
    });
    for (std::uint32_t i = 0; i < 5; ++i) crew.add(order(i, "slow"));
  }
  for (std::uint32_t i = 0; i < delivered.size(); ++i)
    EXPECT_EQ(delivered[i], i) << "in order, none left out";
}

}  // namespace
}  // namespace kerf
