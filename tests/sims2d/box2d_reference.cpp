#include "tests/sims2d/box2d_reference.h"

#include <box2d/box2d.h>

#include <algorithm>

#include "sims2d/contact_pair.h"

namespace kerf::test {
namespace {

void copy_body(const b2Body& body, b2World& world) {
  b2BodyDef def;
  def.type = body.GetType();
  def.position = body.GetPosition();
  def.angle = body.GetAngle();
  def.allowSleep = false;
  def.userData.pointer = object_of(const_cast<b2Body&>(body)).index();
  b2FixtureDef fixture;
  fixture.shape = body.GetFixtureList()->GetShape();
  fixture.density = 1;
  world.CreateBody(&def)->CreateFixture(&fixture);
}

}  // namespace

Reference box2d_contacts(const b2World& world) {
  std::vector<const b2Body*> bodies;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    bodies.push_back(body);
  std::reverse(bodies.begin(), bodies.end());  // Box2D lists the newest first
  b2World copy(b2Vec2(0, 0));
  Reference reference;
  for (const b2Body* body : bodies) {
    copy_body(*body, copy);
    reference.awake.push_back(body->GetType() != b2_staticBody && body->IsAwake());
  }
  copy.Step(0, 1, 1);  // a step of no time: contacts are found and looked at, nothing moves
  for (b2Contact* contact = copy.GetContactList(); contact != nullptr; contact = contact->GetNext())
    if (contact->IsTouching()) reference.touching.insert(pair_of(*contact));
  return reference;
}

}  // namespace kerf::test
