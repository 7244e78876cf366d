#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viz/debugger/model/debugger_model.h"

namespace kerf {

/// Something that a search leads to.
struct SearchHit {
  std::string text;  ///< what is searched for, whole: "n17", "step 40", "next split"
  std::string note;  ///< what it is or does, or its key
  std::function<void(DebuggerModel&)> go;
};

/// Whether each word of a query is part of a name, capitals not counted.
bool has_all_words(const std::string& name, const std::string& query);

/// What the words of a query name at this moment: nodes (n17), objects, pairs (12,77), events (e1234), steps,
/// bookmarks by the words of their notes, commands of which all words are part, and for a condition
/// (op==merge && depth>8) its next and previous moment and a breakpoint; queries (ray 0,2,1,0). Things come
/// first.
std::vector<SearchHit> find_hits(DebuggerModel& model, std::string_view query);

/// Whether each word of a query is part of a name, in capital or small letters.
bool has_all_words(std::string_view name, std::string_view query);

}  // namespace kerf
