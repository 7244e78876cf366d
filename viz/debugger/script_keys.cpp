#include "viz/debugger/script_keys.h"

namespace kerf {

const std::map<std::string, Key>& key_names() {
  static const std::map<std::string, Key> kNames{{"space", Key::space}, {",", Key::comma},
                                                 {".", Key::period},    {"home", Key::home},
                                                 {"end", Key::end},     {"f", Key::f},
                                                 {"h", Key::h},         {"i", Key::i},
                                                 {"b", Key::b},         {"o", Key::o},
                                                 {"?", Key::question},  {"escape", Key::escape},
                                                 {"enter", Key::enter}, {"backspace", Key::backspace},
                                                 {"f1", Key::f1},       {"f5", Key::f5},
                                                 {"f9", Key::f9},       {"f12", Key::f12},
                                                 {"delete", Key::del},  {"left", Key::left},
                                                 {"right", Key::right}, {"up", Key::up},
                                                 {"down", Key::down},   {"+", Key::plus},
                                                 {"-", Key::minus},     {"c", Key::c},
                                                 {"m", Key::m},         {"k", Key::k},
                                                 {"n", Key::n},         {"s", Key::s},
                                                 {"e", Key::e},         {"l", Key::l},
                                                 {"r", Key::r},         {"a", Key::a},
                                                 {"u", Key::u},         {"d", Key::d},
                                                 {"q", Key::q},         {"x", Key::x},
                                                 {"t", Key::t},         {"j", Key::j},
                                                 {"g", Key::g},         {"p", Key::p},
                                                 {"tab", Key::tab},     {"w", Key::w},
                                                 {"v", Key::v},         {"y", Key::y},
                                                 {"z", Key::z},         {"f10", Key::f10},
                                                 {"=", Key::plus}};
  return kNames;
}

std::optional<Key> key_called(const std::string& name) {
  if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return key_of_digit(name[0] - '0');
  const auto found = key_names().find(name);
  return found == key_names().end() ? std::nullopt : std::optional(found->second);
}

}  // namespace kerf
