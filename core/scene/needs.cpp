#include "core/scene/needs.h"

namespace kerf {

Config default_config(const Needs& needs) {
  Config config;
  config.free_directions = needs.free_directions;
  return config;
}

std::string describe(const Needs& needs) {
  std::string text = needs.dimension == 2 ? "2D" : "3D";
  text += ", volume " + std::string(to_string(needs.volume));
  text += needs.fixed_objects ? ", fixed and moving" : ", all moving";
  text += needs.rotation ? ", turning" : ", not turning";
  text += needs.free_directions ? ", free directions" : ", axis directions";
  text += ", separated along ";
  for (int axis = 0; axis < needs.dimension; ++axis)
    if (needs.separating[static_cast<std::size_t>(axis)]) text += "xyz"[axis];
  text += needs.contacts ? ", contacts" : ", pairs only";
  return text;
}

}  // namespace kerf
