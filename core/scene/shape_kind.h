#pragma once

#include <memory>
#include <variant>

#include "core/base/overloaded.h"
#include "core/scene/shape.h"

namespace kerf {

/// The brick that a shape is; null if it is another one.
template <int D>
const Brick<D>* brick_of(const Shape<D>& shape) {
  using Answer = const Brick<D>*;
  return std::visit(Overloaded{[](const Brick<D>& brick) -> Answer { return &brick; },
                               [](const Ball&) -> Answer { return nullptr; },
                               [](const Outline&) -> Answer { return nullptr; },
                               [](const std::shared_ptr<const Surface>&) -> Answer { return nullptr; }},
                    shape);
}

template <int D>
bool is_ball(const Shape<D>& shape) {
  return std::visit(Overloaded{[](const Ball&) { return true; }, [](const Brick<D>&) { return false; },
                               [](const Outline&) { return false; },
                               [](const std::shared_ptr<const Surface>&) { return false; }},
                    shape);
}

}  // namespace kerf
