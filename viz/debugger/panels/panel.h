#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/replay/position.h"
#include "viz/debugger/gui/gui.h"
#include "viz/debugger/model/debugger_model.h"
#include "viz/debugger/model/figure_table.h"
#include "viz/debugger/model/icicle_state.h"
#include "viz/debugger/scene/scene_view.h"
#include "viz/debugger/window/window_settings.h"

namespace kerf {

/// A panel to be copied.
struct CopyWish {
  std::string panel;  ///< its name, see copying.h; empty: the one under the mouse, or the last one used
  bool as_csv = false;
};

/// What panels and keys ask of the debugger, which does it in the next frame, and what it answers.
struct SessionMemory {
  std::string offer;                          ///< what a kept session has; empty: none is offered
  std::string offer_warning;                  ///< why it may not fit
  std::optional<bool> answer;                 ///< to the offer: go on there, or begin anew
  std::optional<std::filesystem::path> open;  ///< a recording to go to
  std::vector<std::string> recent;            ///< recordings that were opened lately, the latest first
  int changes_back = 0;                       ///< changes of the view to take back; below zero: to make again
  std::optional<Position> note_of;            ///< the bookmark whose note takes the keys in the next frame
  std::optional<CopyWish> copy;
  std::string used_panel;  ///< the name of the last one that was clicked
};

/// The search box.
struct SearchMemory {
  bool is_open = false;
  bool begins = false;  ///< it takes the keys in the next frame
  std::string text;
  int completions = 0;
  std::size_t chosen = 0;            ///< of what was found
  std::vector<std::string> history;  ///< the latest first
};

inline void open_search(SearchMemory& search) {
  search.is_open = search.begins = true;
  search.text.clear();
  search.chosen = 0;
}

/// The state of panels between frames that does not belong to the model.
struct PanelMemory {
  bool help = false;
  bool welcome = false;               ///< what is seen, in words, and the legend
  std::optional<std::size_t> tour;    ///< the stop of the tour; none: there is no tour
  std::optional<std::size_t> toured;  ///< the stop that has been set up
  SearchMemory search;
  SessionMemory session;
  std::string under_mouse = "nothing";  ///< in the view
  bool screenshot = false;              ///< requested in this frame
  bool operators_only = true;           ///< the list of events leaves out placed objects
  std::set<NodeId> unfolded;            ///< of the outline, beyond what is unfolded at first
  std::set<NodeId> folded;
  std::string condition;  ///< being typed
  std::string watch;
  std::string problem;  ///< the error in the typed text
  std::string go_to;
  std::optional<Position> listed;     ///< moment to which the lists have scrolled
  std::optional<Selection> outlined;  ///< what the outline has scrolled to
  std::string open_tab;               ///< to open in the next frame; empty: no change
  WindowSettings window;
  std::array<float, 3> extents{};     ///< of the places of panels, as shares of the window
  std::optional<PanelId> held_panel;  ///< the mouse has pressed its title
  bool menu_wanted = false;           ///< of the panel that is drawn
  bool window_menu_wanted = false;
  std::optional<std::string> press;  ///< a part that is to be clicked, by its name
  std::optional<Selection> explained;
  Position explained_at;
  std::string explained_query;
  std::string explanation;
  Position lit_at;                            ///< moment to which Algorithm 1 has scrolled
  std::optional<std::size_t> kept_candidate;  ///< of the ballot, pressed
  Position ballot_of;
  std::string other_file;
  std::string assignments;  ///< of "what if"
  std::string problem_of_what_if;
  int lint_within = 50;
  TableKeeper table;
  TableOf table_of = TableOf::nodes;
  std::array<TableOrder, 4> table_order{{{}, {}, {}, {1, false}}};  ///< by what they list; errors by step
  std::string table_filter;
  std::optional<Selection> tabled;          ///< what the table has scrolled to
  std::optional<std::size_t> tabled_error;  ///< the same of errors, by its number
  std::string copied;                       ///< the last text that was copied
  std::optional<std::string> to_clipboard;  ///< not taken yet
  IcicleKeeper icicle;
  bool before_operator = false;        ///< the icicle shows the tree before the last operator
  std::optional<NodeId> hovered_node;  ///< under the mouse in this frame
  std::optional<double> range_from;    ///< the time at which a drag over the lanes began to select a range
};

/// What a panel may read and change.
struct PanelContext {
  DebuggerModel& model;
  Gui& gui;
  PanelMemory& memory;
  SceneView& view;
};

/// "leaf 23", or the population, balance and straddlers of a partitioner: the same words in every panel.
std::string node_words(const TreeSnapshot& tree, NodeId id);

/// What the mouse is over, in a line: "object 12: 3 pairs".
std::string thing_words(Run& run, const Selection& thing);

// Each is one file of this folder and fills the window or tab that has been begun.
void draw_transport(PanelContext& context);
void draw_timeline(PanelContext& context);
void draw_outline(PanelContext& context);
void draw_icicle(PanelContext& context);
void draw_breakpoints(PanelContext& context);
/// The bookmarks and their notes, below the breakpoints.
void draw_bookmarks(PanelContext& context);
/// Whether to go on where a kept session was.
void draw_session_offer(PanelContext& context);
/// Puts the panel that the user wants to copy into the clipboard.
void copy_as_wished(PanelContext& context);
void draw_events(PanelContext& context);
void draw_why(PanelContext& context);
void draw_ballot(PanelContext& context);
void draw_algorithm(PanelContext& context);
void draw_oracle(PanelContext& context);
void draw_what_if(PanelContext& context);
void draw_compare(PanelContext& context);
void draw_lint(PanelContext& context);
void draw_tables(PanelContext& context);
void draw_view_tools(PanelContext& context);
void draw_view_overlay(PanelContext& context, const SceneView& view, const PanelArea& area,
                       const std::string& title);
/// The heights, in units, that the overlay's usual lines take at the top and at the bottom of a view; at the
/// top with a line for the label of what lies highest.
float overlay_above();
float overlay_below();
void draw_welcome(PanelContext& context);
void draw_tour(PanelContext& context);
/// What a stop of the tour, counted from 0, says of this run.
std::string tour_text(DebuggerModel& model, std::size_t stop);
void draw_search(PanelContext& context);
void draw_help(PanelContext& context);

}  // namespace kerf
