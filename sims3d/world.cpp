#include "sims3d/world.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <new>
#include <stdexcept>

namespace kerf {
namespace {

/// Soft enough that heaps are calm, hard enough that they do not sink.
constexpr double kErrorReduction = 0.25;
constexpr double kConstraintForceMixing = 1e-3;
constexpr double kSurfaceLayer = 0.01;
constexpr double kMaxCorrectingSpeed = 2;
constexpr double kRestitution = 0.15;
constexpr double kRestitutionSpeed = 1;
constexpr double kMaxAngularSpeed = 12;
constexpr double kLinearDamping = 0.002;
constexpr double kAngularDamping = 0.02;

OdeHandle<dxWorld> make_world(const WorldSettings& settings) {
  OdeHandle<dxWorld> world(dWorldCreate());
  dWorldSetGravity(world.get(), 0, -settings.gravity, 0);
  dWorldSetERP(world.get(), kErrorReduction);
  dWorldSetCFM(world.get(), kConstraintForceMixing);
  dWorldSetQuickStepNumIterations(world.get(), settings.iterations);
  dWorldSetContactSurfaceLayer(world.get(), kSurfaceLayer);
  dWorldSetContactMaxCorrectingVel(world.get(), kMaxCorrectingSpeed);
  dWorldSetMaxAngularSpeed(world.get(), kMaxAngularSpeed);
  dWorldSetDamping(world.get(), kLinearDamping, kAngularDamping);
  dWorldSetAutoDisableFlag(world.get(), 0);  // `Sleep` decides instead
  return world;
}

void accept(Status status, const BroadPhase<3>& broad_phase, ObjectId object) {
  if (status == Status::ok || status == Status::clamped) return;
  throw std::runtime_error("the broad phase " + std::string(broad_phase.name()) + " refuses object " +
                           std::to_string(object.value) + ": " + std::string(to_string(status)));
}

void set_pose(dBodyID body, const Pose<3>& pose) {
  dMatrix3 rotation{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      rotation[4 * j + i] = static_cast<double>(pose.axes[static_cast<std::size_t>(i)][j]);
  dBodySetRotation(body, rotation);
  dBodySetPosition(body, static_cast<double>(pose.position[0]), static_cast<double>(pose.position[1]),
                   static_cast<double>(pose.position[2]));
}

void set_motion(dBodyID body, const Twist& motion) {
  dBodySetLinearVel(body, static_cast<double>(motion.linear[0]), static_cast<double>(motion.linear[1]),
                    static_cast<double>(motion.linear[2]));
  dBodySetAngularVel(body, static_cast<double>(motion.angular[0]), static_cast<double>(motion.angular[1]),
                     static_cast<double>(motion.angular[2]));
}

bool is_finite(const dReal* values, int count) {
  return std::all_of(values, values + count, [](dReal x) { return std::isfinite(x); });
}

}  // namespace

OdeWorld::OdeWorld(BroadPhase<3>& broad_phase, std::uint64_t seed, const WorldSettings& settings)
    : broad_phase_(broad_phase),
      settings_(settings),
      sleep_(settings.sleep),
      solver_seed_(static_cast<unsigned long>(seed & 0xFFFFFFFFU)) {
  const auto lock = library_.enter();
  world_ = make_world(settings);
  joints_.reset(dJointGroupCreate(0));
}

OdeWorld::~OdeWorld() {
  const auto lock = library_.enter();
  geoms_.clear();
  rigid_.clear();
  joints_.reset();
  world_.reset();
}

ObjectId OdeWorld::add_fixed(const Shape<3>& shape, const Vector<3>& position) {
  const auto lock = library_.enter();
  Geom geom = make_geom(shape);
  dGeomSetPosition(geom.geom.get(), static_cast<double>(position[0]), static_cast<double>(position[1]),
                   static_cast<double>(position[2]));
  return add(std::move(geom), nullptr, shape, Mobility::fixed);
}

ObjectId OdeWorld::add_moving(const Shape<3>& shape, const Pose<3>& pose, const Twist& motion) {
  const auto lock = library_.enter();
  Geom geom = make_geom(shape);
  const dMass mass = make_mass(shape, settings_.density);
  OdeHandle<dxBody> rigid(dBodyCreate(world_.get()));
  dBodySetMass(rigid.get(), &mass);
  set_pose(rigid.get(), pose);
  set_motion(rigid.get(), motion);
  dGeomSetBody(geom.geom.get(), rigid.get());
  return add(std::move(geom), std::move(rigid), shape, Mobility::moving);
}

ObjectId OdeWorld::add(Geom geom, OdeHandle<dxBody> rigid, const Shape<3>& shape, Mobility mobility) {
  const ObjectId object{static_cast<std::uint32_t>(bodies_.size())};
  const Volume<3> volume = outward_volume(broad_phase_.volume_kind(), shape, geom.geom.get());
  accept(broad_phase_.insert(object, volume, mobility), broad_phase_, object);
  bodies_.push_back({shape, pose_of(geom.geom.get()), volume.box, mobility});
  rigid_.push_back(std::move(rigid));
  geoms_.push_back(std::move(geom));
  moved_.push_back(1);
  max_speeds_.push_back(settings_.max_speed);
  return object;
}

dBodyID OdeWorld::moving_body(ObjectId object) const {
  if (object.index() >= rigid_.size() || !rigid_[object.index()])
    throw std::invalid_argument("only a moving object can be placed, pushed, reshaped or asked how it moves");
  return rigid_[object.index()].get();
}

void OdeWorld::place(ObjectId object, const Vector<3>& position, const Twist& motion) {
  dBodyID body = moving_body(object);
  const auto lock = library_.enter();
  dBodySetPosition(body, static_cast<double>(position[0]), static_cast<double>(position[1]),
                   static_cast<double>(position[2]));
  set_motion(body, motion);
  sleep_.wake(object, body);
  moved_[object.index()] = 1;
}

void OdeWorld::push(ObjectId object, const Vector<3>& acceleration) {
  dBodyID body = moving_body(object);
  const auto lock = library_.enter();
  dMass mass;
  dBodyGetMass(body, &mass);
  dBodyAddForce(body, mass.mass * static_cast<double>(acceleration[0]),
                mass.mass * static_cast<double>(acceleration[1]),
                mass.mass * static_cast<double>(acceleration[2]));
}

void OdeWorld::reshape(ObjectId object, const Shape<3>& shape) {
  dBodyID body = moving_body(object);
  const auto lock = library_.enter();
  Geom geom = make_geom(shape);
  const dMass mass = make_mass(shape, settings_.density);
  dBodySetMass(body, &mass);
  dGeomSetBody(geom.geom.get(), body);
  geoms_[object.index()] = std::move(geom);
  bodies_[object.index()].shape = shape;
  sleep_.wake(object, body);
  moved_[object.index()] = 1;
}

void OdeWorld::set_max_speed(ObjectId object, double speed) {
  static_cast<void>(moving_body(object));
  max_speeds_[object.index()] = speed;
}

Twist OdeWorld::twist_of(ObjectId object) const {
  const dBodyID body = moving_body(object);
  const dReal* linear = dBodyGetLinearVel(body);
  const dReal* angular = dBodyGetAngularVel(body);
  Twist motion;
  for (int i = 0; i < 3; ++i) {
    motion.linear[i] = static_cast<Scalar>(linear[i]);
    motion.angular[i] = static_cast<Scalar>(angular[i]);
  }
  return motion;
}

void OdeWorld::advance() {
  {
    const auto lock = library_.enter();
    update_boxes();
  }
  broad_phase_.step();
  sort_pairs();
  const auto lock = library_.enter();
  find_contacts();
  wake();
  join();
  integrate();
  ++step_;
}

void OdeWorld::update_boxes() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (moved_[i] == 0 || !rigid_[i]) continue;
    const ObjectId object{static_cast<std::uint32_t>(i)};
    const VolumeKind kind = broad_phase_.volume_kind();
    const Volume<3> volume = outward_volume(kind, bodies_[i].shape, geoms_[i].geom.get());
    bodies_[i].pose = pose_of(geoms_[i].geom.get());
    // A body that turns may keep its box; any other volume has turned with it.
    if (kind == VolumeKind::box && volume.box == bodies_[i].box) continue;
    moves_.add(object, volume);
    bodies_[i].box = volume.box;
  }
  if (const auto refusal = moves_.send(broad_phase_)) accept(refusal->status, broad_phase_, refusal->object);
}

void OdeWorld::sort_pairs() {
  pairs_.clear();
  for (const Pair pair : broad_phase_.pairs()) {
    const Pair ordered = make_pair(pair.a, pair.b);
    if (ordered.b.index() >= bodies_.size() || ordered.a == ordered.b)
      throw std::runtime_error("the broad phase " + std::string(broad_phase_.name()) + " gives the pair " +
                               std::to_string(pair.a.value) + ", " + std::to_string(pair.b.value) +
                               ", which no objects have");
    pairs_.push_back(ordered);
  }
  std::sort(pairs_.begin(), pairs_.end());
}

void OdeWorld::find_contacts() {
  candidates_.clear();
  std::unique_copy(pairs_.begin(), pairs_.end(), std::back_inserter(candidates_));
  std::erase_if(candidates_,
                [this](const Pair& pair) { return !rigid_[pair.a.index()] && !rigid_[pair.b.index()]; });
  narrow_phase_.run(candidates_, geoms_, moved_);
  std::fill(moved_.begin(), moved_.end(), std::uint8_t{0});
}

bool OdeWorld::is_asleep(ObjectId object) const {
  dBodyID body = rigid_[object.index()].get();
  return body != nullptr && dBodyIsEnabled(body) == 0;
}

bool OdeWorld::is_awake(ObjectId object) const {
  dBodyID body = rigid_[object.index()].get();
  return body != nullptr && dBodyIsEnabled(body) != 0;
}

/// A sleeper wakes when something that it touched is gone, as it may have rested on it, or when it is hit.
void OdeWorld::wake() {
  for (const Pair pair : narrow_phase_.parted())
    for (const ObjectId object : {pair.a, pair.b})
      if (is_asleep(object)) sleep_.wake(object, rigid_[object.index()].get());
  for (const Touch& touch : narrow_phase_.touches())
    if (is_asleep(touch.pair.a) != is_asleep(touch.pair.b)) wake_hit(touch);
}

void OdeWorld::wake_hit(const Touch& touch) {
  const bool first_sleeps = is_asleep(touch.pair.a);
  const ObjectId sleeper = first_sleeps ? touch.pair.a : touch.pair.b;
  const ObjectId other = first_sleeps ? touch.pair.b : touch.pair.a;
  if (!is_awake(other)) return;
  for (const dContactGeom& point : narrow_phase_.points(touch, geoms_)) {
    dVector3 velocity{};
    dBodyGetPointVel(rigid_[other.index()].get(), point.pos[0], point.pos[1], point.pos[2], velocity);
    // The normal points into the first geom.
    const double sign = point.g1 == geoms_[sleeper.index()].geom.get() ? 1 : -1;
    if (!sleep_.wakes(sign * dCalcVectorDot3(velocity, point.normal))) continue;
    sleep_.wake(sleeper, rigid_[sleeper.index()].get());
    return;
  }
}

void OdeWorld::join() {
  dJointGroupEmpty(joints_.get());
  for (const Touch& touch : narrow_phase_.touches())
    if (is_awake(touch.pair.a) || is_awake(touch.pair.b)) join(touch);
}

void OdeWorld::join(const Touch& touch) {
  dContact contact{};
  contact.surface.mode = dContactApprox1 | dContactBounce;
  contact.surface.mu = settings_.friction;
  contact.surface.bounce = kRestitution;
  contact.surface.bounce_vel = kRestitutionSpeed;
  dBodyID first = is_awake(touch.pair.a) ? rigid_[touch.pair.a.index()].get() : nullptr;
  dBodyID second = is_awake(touch.pair.b) ? rigid_[touch.pair.b.index()].get() : nullptr;
  for (const dContactGeom& point : narrow_phase_.points(touch, geoms_)) {
    contact.geom = point;
    const bool swapped = point.g1 != geoms_[touch.pair.a.index()].geom.get();
    dJointID joint = dJointCreateContact(world_.get(), joints_.get(), &contact);
    dJointAttach(joint, swapped ? second : first, swapped ? first : second);
  }
}

void OdeWorld::integrate() {
  // ODE has one seed for all worlds; ours replaces it for the time of the step.
  const unsigned long others = dRandGetSeed();
  dRandSetSeed(solver_seed_);
  const int done = dWorldQuickStep(world_.get(), settings_.step_seconds);
  solver_seed_ = dRandGetSeed();
  dRandSetSeed(others);
  if (done == 0) throw std::bad_alloc();

  awake_ = 0;
  for (std::size_t i = 0; i < rigid_.size(); ++i) {
    const ObjectId object{static_cast<std::uint32_t>(i)};
    if (!is_awake(object)) continue;
    ++awake_;
    moved_[i] = 1;
    check_and_limit(object, rigid_[i].get());
    sleep_.observe(object, rigid_[i].get());
  }
}

void OdeWorld::check_and_limit(ObjectId object, dBodyID body) const {
  const dReal* velocity = dBodyGetLinearVel(body);
  if (!is_finite(dBodyGetPosition(body), 3) || !is_finite(dBodyGetQuaternion(body), 4) ||
      !is_finite(velocity, 3))
    throw std::runtime_error("object " + std::to_string(object.value) + " has no finite pose after step " +
                             std::to_string(step_ + 1) + ": the simulation has broken down");
  const double speed = dCalcVectorLength3(velocity);
  const double max_speed = max_speeds_[object.index()];
  if (speed <= max_speed) return;
  const double scale = max_speed / speed;
  dBodySetLinearVel(body, velocity[0] * scale, velocity[1] * scale, velocity[2] * scale);
}

}  // namespace kerf
