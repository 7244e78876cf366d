#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/box.h"
#include "core/recording/look.h"
#include "frames/import/given_objects.h"
#include "frames/import/oddities.h"
#include "frames/import/survey.h"

namespace kerf {

/// How the objects of an import look: what a table of objects says of them, and how they are turned.
template <int D>
class ShownObjects {
 public:
  /// `name` is that of the table. Notes lines of objects that the run does not have.
  ShownObjects(const std::vector<GivenObject<D>>& given, const std::string& name, const Survey& survey,
               Oddities& oddities);

  [[nodiscard]] const ObjectMarks& marks() const { return marks_; }
  [[nodiscard]] bool has_shapes() const { return !shapes_.empty(); }
  /// Its box from now on, and how it is turned (see BoxLine) if that is said. False: it has a shape, and that
  /// is larger than the box.
  bool place(ObjectId object, const Box<D>& box, const std::optional<std::array<double, 4>>& turn);
  /// Without a shape if none is known, or if it is larger than the box.
  [[nodiscard]] Appearance<D> appearance(ObjectId object) const;

 private:
  struct Shown {
    Shape<D> shape;
    Turn<D> turn = turn_of<D>(identity_axes<D>());
    bool fits = false;
  };

  ObjectMarks marks_;
  std::map<ObjectId, Shown> shapes_;
};

}  // namespace kerf
