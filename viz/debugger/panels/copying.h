#pragma once

#include <array>
#include <string>
#include <string_view>

#include "viz/debugger/model/text_table.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {

/// A panel that can be copied.
struct CopiedPanel {
  std::string_view name;
  std::string_view place;  ///< its area is "panel PLACE"
  bool is_table = true;
};
inline constexpr std::array kCopiedPanels{CopiedPanel{"moment line", "transport", false},
                                          CopiedPanel{"tree", "tree"},
                                          CopiedPanel{"icicle", "icicle"},
                                          CopiedPanel{"breakpoints and bookmarks", "breakpoints"},
                                          CopiedPanel{"events", "events"},
                                          CopiedPanel{"why", "why", false},
                                          CopiedPanel{"ballot", "ballot"},
                                          CopiedPanel{"algorithm", "algorithm", false},
                                          CopiedPanel{"oracle", "oracle"},
                                          CopiedPanel{"compare", "compare"},
                                          CopiedPanel{"lint", "lint"},
                                          CopiedPanel{"table", "tables"},
                                          CopiedPanel{"lanes", "timeline"},
                                          CopiedPanel{"what if", "what if"},
                                          CopiedPanel{"scene", "view"}};

/// "e278 step 40 split n0: ...", "end of step 17": the present moment in words.
std::string moment_words(const Run& run);
/// The events that the list of events shows.
std::vector<const Event*> listed_events(const PanelContext& context);
/// "split n5: 65 -> 65 (33 | 34)" without id and step.
std::string deed_text(const Event& event, const GivenNames& names);
/// A word that fits a narrow column.
const char* result_word(const BallotEntry& entry);
/// The explanation that the panel "why" shows. Computed once for each moment and selection.
const std::string& explanation_of(PanelContext& context);

/// A figure of two compared runs.
struct ComparedFigure {
  std::string name;
  double a = 0;
  double b = 0;
};
std::vector<ComparedFigure> compared_figures(const RecordingComparison& comparison);

/// Puts a text into the clipboard, and says what it is.
void put_into_clipboard(PanelContext& context, std::string text, const std::string& what);

}  // namespace kerf
