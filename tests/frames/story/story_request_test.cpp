#include "frames/story/story_request.h"

#include <gtest/gtest.h>

#include "frames/story/story_still.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

LayerSet layers_of(const std::string& show) {
  StoryTexts texts;
  texts.pictures.scene = "pile";
  texts.pictures.video = "film.mp4";
  texts.pictures.show = show;
  return parse_story_request(texts).pictures.layers;
}

TEST(StoryRequest, ChangesOfLayersAreToThoseOfAFilm) {
  EXPECT_EQ(to_string(layers_of("")), "objects,partitioners,leaves,operators");
  EXPECT_EQ(to_string(layers_of("+pairs")), "objects,partitioners,leaves,pairs,operators");
  EXPECT_EQ(to_string(layers_of("-leaves,+contacts")), "objects,partitioners,contacts,operators");
  EXPECT_EQ(to_string(layers_of("objects,pairs")), "objects,pairs");
  EXPECT_EQ(layers_of("all"), layers_of("+pairs,+contacts"));
  for (const char* const words : {"+legend", "objects,caption"})
    EXPECT_THROW((void)layers_of(words), UsageError);
}

StoryMoment moment_at(std::uint32_t step, std::uint32_t population) {
  StoryMoment moment;
  moment.step = step;
  moment.acted.after.population = population;
  return moment;
}

TEST(StoryStill, OfAFilmThatStandsStillIsTheLargestMoment) {
  const std::vector<StoryMoment> moments{moment_at(20, 30), moment_at(60, 90)};
  const std::vector<std::uint32_t> stops{20, 60};
  const auto frames = story_frames(1, 100, stops, 600, 50);
  const StoryFrame& still = frames[frame_of_still(frames, moments, moments, 50)];
  EXPECT_EQ(still.moment, 1U);
  EXPECT_NEAR(still.progress, 0.45, 0.02);
}

TEST(StoryStill, OfAShortFilmIsBehindTheLargestOperator) {
  const std::vector<StoryMoment> operators{moment_at(20, 30), moment_at(80, 90), moment_at(90, 40)};
  const auto frames = story_frames(1, 100, {}, 40, 50);
  const std::uint32_t still = frame_of_still(frames, {}, operators, 50);
  EXPECT_GE(frames[still].step, 80);
  EXPECT_LT(frames[still - 1].step, 80);
  EXPECT_EQ(frame_of_still(frames, {}, {}, 50), frames.size() / 2);
}

}  // namespace
}  // namespace kerf
