#include <box2d/box2d.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "core/base/random.h"
#include "sims2d/box2d/box2d_broad_phase.h"

namespace kerf {
namespace {

/// Bodies and fixtures that come and go at random. Fixtures are numbered; those of the last update are known.
class ComingAndGoing {
 public:
  void change() {
    const std::size_t k = bodies_.empty() ? 0 : random_.below(static_cast<std::uint32_t>(bodies_.size()));
    switch (bodies_.empty() ? 0 : random_.below(6)) {
      case 0:
        bodies_.push_back(create());
        break;
      case 1:
        world_.DestroyBody(bodies_[k]);
        bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      case 2:
        if (bodies_[k]->GetFixtureList() != nullptr) bodies_[k]->DestroyFixture(bodies_[k]->GetFixtureList());
        break;
      case 3:
        bodies_[k]->SetEnabled(false);
        forget(*bodies_[k]);
        break;
      case 4:
        bodies_[k]->SetEnabled(true);
        break;
      default:
        add_fixture(*bodies_[k]);
    }
  }
  void update() {
    broad_phase_.update(1.0F / 60);
    known_ = present();
  }
  std::vector<std::uintptr_t> expected() {
    std::vector<std::uintptr_t> both;
    for (const std::uintptr_t number : present())
      if (known_.contains(number)) both.push_back(number);
    return both;
  }
  std::vector<std::uintptr_t> found() {
    struct : b2QueryCallback {
      bool ReportFixture(b2Fixture* fixture) override {
        numbers.push_back(fixture->GetUserData().pointer);
        return true;
      }
      std::vector<std::uintptr_t> numbers;
    } callback;
    broad_phase_.query(callback, {{-9, -9}, {9, 9}});
    return callback.numbers;
  }
  std::uint32_t below(std::uint32_t most) { return random_.below(most); }

 private:
  b2Body* create() {
    b2BodyDef def;
    def.type = random_.below(2) == 0 ? b2_dynamicBody : b2_staticBody;
    def.enabled = random_.below(8) != 0;
    b2Body* const body = world_.CreateBody(&def);
    for (std::uint32_t count = random_.below(3); count > 0; --count) add_fixture(*body);
    return body;
  }
  void add_fixture(b2Body& body) {
    b2CircleShape shape;
    shape.m_radius = 0.5F;
    b2FixtureDef def;
    def.shape = &shape;
    def.userData.pointer = ++last_;
    body.CreateFixture(&def);
  }
  /// A disabled body is as if it were new when it is enabled.
  void forget(const b2Body& body) {
    for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext())
      known_.erase(const_cast<b2Fixture*>(f)->GetUserData().pointer);
  }
  std::set<std::uintptr_t> present() {
    std::set<std::uintptr_t> numbers;
    for (const b2Body* body : bodies_)
      for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        if (body->IsEnabled()) numbers.insert(const_cast<b2Fixture*>(f)->GetUserData().pointer);
    return numbers;
  }

  Random random_{13};
  b2World world_{b2Vec2(0, 0)};
  Box2dBroadPhase broad_phase_{world_};
  std::vector<b2Body*> bodies_;
  std::set<std::uintptr_t> known_;
  std::uintptr_t last_ = 0;
};

TEST(Box2dBroadPhase, QueriesReportWhatIsLeftOfTheLastUpdateInWhateverOrderThingsComeAndGo) {
  ComingAndGoing things;
  std::size_t reported = 0;
  for (int round = 0; round < 20000; ++round) {
    if (things.below(8) == 0) things.update();
    for (std::uint32_t count = things.below(6); count > 0; --count) things.change();
    const std::vector<std::uintptr_t> expected = things.expected();
    ASSERT_THAT(things.found(), testing::UnorderedElementsAreArray(expected)) << round;
    reported += expected.size();
  }
  EXPECT_GT(reported, 20000U);
}

}  // namespace
}  // namespace kerf
