#include "sims2d/world.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sims2d/box2d/box2d_contacts.h"
#include "sims2d/contact_pair.h"
#include "sims2d/convert.h"

namespace kerf::inline sims2d {
namespace {

constexpr int32 kVelocityIterations = 10;
constexpr int32 kPositionIterations = 4;
constexpr float kFriction = 0.4F;
constexpr float kRestitution = 0.1F;
constexpr float kSpinDrag = 1.0F;

std::string name_of(std::size_t object) { return "object " + std::to_string(object); }

void check_plan(const BodyPlan& plan) {
  const bool finite = is_finite(plan.position) && is_finite(plan.velocity) && std::isfinite(plan.angle) &&
                      std::isfinite(plan.spin);
  if (!finite) throw std::invalid_argument("the pose and the motion of a new body must be finite");
}

b2BodyDef definition(const BodyPlan& plan, std::size_t object) {
  b2BodyDef def;
  if (plan.mobility == Mobility::moving) def.type = plan.driven ? b2_kinematicBody : b2_dynamicBody;
  def.position.Set(plan.position[0], plan.position[1]);
  def.angle = plan.angle;
  def.linearVelocity.Set(plan.velocity[0], plan.velocity[1]);
  def.angularVelocity = plan.spin;
  def.linearDamping = plan.driven ? 0 : Box2dWorld::kDrag;
  def.angularDamping = plan.driven ? 0 : kSpinDrag;
  def.userData.pointer = object;
  return def;
}

b2FixtureDef material(const b2Shape& shape) {
  b2FixtureDef def;
  def.shape = &shape;
  def.density = 1.0F;
  def.friction = kFriction;
  def.restitution = kRestitution;
  return def;
}

bool same(const Pose<2>& a, const Pose<2>& b) { return a.position == b.position && a.axes == b.axes; }

bool is_finite(const Pose<2>& pose) {
  return is_finite(pose.position) && is_finite(pose.axes[0]) && is_finite(pose.axes[1]);
}

}  // namespace

Box2dWorld::Box2dWorld(BroadPhase<2>& broad_phase, Scalar gravity)
    : broad_phase_(broad_phase),
      engine_(std::make_unique<b2World>(b2Vec2(0.0F, -gravity))),
      admitted_(std::make_unique<Box2dContacts>(*engine_)) {
  engine_->SetContinuousPhysics(false);
}

Box2dWorld::~Box2dWorld() = default;

ObjectId Box2dWorld::add(const BodyPlan& plan) {
  check_plan(plan);
  const std::unique_ptr<b2Shape> shape = to_box2d(plan.shape);
  const ObjectId object{static_cast<std::uint32_t>(bodies_.size())};
  const b2BodyDef def = definition(plan, object.index());
  const b2Transform transform(def.position, b2Rot(def.angle));
  const Volume<2> volume = padded_volume(broad_phase_.volume_kind(), plan.shape, *shape, transform);
  const Status status = broad_phase_.insert(object, volume, plan.mobility);
  if (status != Status::ok)
    throw std::runtime_error("the broad phase refused " + name_of(object.index()) + ": " +
                             std::string(to_string(status)) + "; a world needs an empty one");
  const b2FixtureDef fixture = material(*shape);
  handles_.push_back(engine_->CreateBody(&def));
  admitted_->adopt(*handles_.back()->CreateFixture(&fixture), std::span(&object, 1));
  bodies_.push_back({plan.shape, to_pose(transform), volume.box, plan.mobility});
  reshaped_.push_back(0);
  return object;
}

b2Body& Box2dWorld::moving_body(ObjectId object) const {
  if (object.index() >= bodies_.size() || bodies_[object.index()].mobility == Mobility::fixed)
    throw std::invalid_argument("only a moving object can be placed, pushed, reshaped or asked how it moves");
  return *handles_[object.index()];
}

void Box2dWorld::push(ObjectId object, const Vector<2>& acceleration) {
  b2Body& body = moving_body(object);
  const float mass = body.GetMass();
  body.ApplyForceToCenter({mass * acceleration[0], mass * acceleration[1]}, true);
}

void Box2dWorld::reshape(ObjectId object, const Shape<2>& shape) {
  b2Body& body = moving_body(object);
  const std::unique_ptr<b2Shape> made = to_box2d(shape);
  const b2FixtureDef fixture = material(*made);
  admitted_->forget(*body.GetFixtureList());
  body.DestroyFixture(body.GetFixtureList());
  admitted_->adopt(*body.CreateFixture(&fixture), std::span(&object, 1));
  body.SetAwake(true);
  bodies_[object.index()].shape = shape;
  reshaped_[object.index()] = 1;
}

Vector<2> Box2dWorld::velocity_of(ObjectId object) const {
  const b2Vec2& velocity = moving_body(object).GetLinearVelocity();
  return {{velocity.x, velocity.y}};
}

Scalar Box2dWorld::spin_of(ObjectId object) const { return moving_body(object).GetAngularVelocity(); }

void Box2dWorld::place(ObjectId object, const BodyPlan& plan) {
  b2Body& body = moving_body(object);
  check_plan(plan);
  body.SetTransform({plan.position[0], plan.position[1]}, plan.angle);
  body.SetLinearVelocity({plan.velocity[0], plan.velocity[1]});
  body.SetAngularVelocity(plan.spin);
  body.SetAwake(true);
}

void Box2dWorld::advance() {
  ++step_;
  update_boxes();
  ask();
  admitted_->admit(pairs_);
  engine_->Step(kStepSeconds, kVelocityIterations, kPositionIterations);
  collect_contacts();
}

void Box2dWorld::update_boxes() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body<2>& body = bodies_[i];
    if (body.mobility == Mobility::fixed) continue;
    const b2Transform& transform = handles_[i]->GetTransform();
    const Pose<2> pose = to_pose(transform);
    if (same(pose, body.pose) && reshaped_[i] == 0) continue;
    if (!is_finite(pose))
      throw std::runtime_error("the pose of " + name_of(i) + " is not finite at step " +
                               std::to_string(step_));
    body.pose = pose;
    reshaped_[i] = 0;
    const b2Shape& shape = *handles_[i]->GetFixtureList()->GetShape();
    const Volume<2> volume = padded_volume(broad_phase_.volume_kind(), body.shape, shape, transform);
    body.box = volume.box;
    moves_.add(ObjectId{static_cast<std::uint32_t>(i)}, volume);
  }
  if (const auto refusal = moves_.send(broad_phase_))
    throw std::runtime_error("the broad phase would not move " + name_of(refusal->object.index()) + ": " +
                             std::string(to_string(refusal->status)));
}

void Box2dWorld::ask() {
  broad_phase_.step();
  const std::span<const Pair> pairs = broad_phase_.pairs();
  pairs_.assign(pairs.begin(), pairs.end());
  std::sort(pairs_.begin(), pairs_.end());
  for (const Pair& pair : pairs_)
    if (pair.a >= pair.b || pair.b.index() >= bodies_.size())
      throw std::runtime_error("the broad phase reported the pair " + std::to_string(pair.a.value) + "-" +
                               std::to_string(pair.b.value) + ", which cannot be");
}

void Box2dWorld::collect_contacts() {
  contacts_.clear();
  for (b2Contact* contact = engine_->GetContactList(); contact != nullptr; contact = contact->GetNext())
    if (contact->IsTouching()) contacts_.push_back(pair_of(*contact));
  std::sort(contacts_.begin(), contacts_.end());
}

}  // namespace kerf::inline sims2d
