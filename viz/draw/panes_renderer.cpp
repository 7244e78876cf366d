#include "viz/draw/panes_renderer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "viz/draw/axis_strips.h"
#include "viz/draw/camera_path.h"
#include "viz/draw/flow.h"
#include "viz/draw/pane_text.h"
#include "viz/draw/structure_draw.h"
#include "viz/gl/context.h"
#include "viz/gl/framebuffer.h"

namespace kerf {
namespace {

constexpr Color kGap{190, 190, 186};
constexpr int kGapPixels = 3;

/// Pictures of panes have smaller letters: each pane has its own.
int letter_height(int picture_height) { return std::max(11, font_pixels(picture_height) * 3 / 4); }

/// Where the panes of a picture are.
struct PaneGrid {
  int columns = 1;
  int rows = 1;
  int top = 0;
  int width = 0;
  int height = 0;

  PaneGrid(int panes, int wanted_columns, int picture_width, int picture_height, int above, int below)
      : columns(wanted_columns), rows((panes + wanted_columns - 1) / wanted_columns), top(above) {
    width = (picture_width - (columns - 1) * kGapPixels) / columns;
    height = (picture_height - above - below - (rows - 1) * kGapPixels) / rows;
  }
  [[nodiscard]] int left_of(std::size_t pane) const {
    return static_cast<int>(pane) % columns * (width + kGapPixels);
  }
  [[nodiscard]] int top_of(std::size_t pane) const {
    return top + static_cast<int>(pane) / columns * (height + kGapPixels);
  }
};

template <int D>
PanesLegend legend_of(const PanesFrame<D>& frame, LayerSet layers) {
  PanesLegend legend{D, false, false, false, false, layers};
  for (const StructurePane<D>& pane : frame.panes) {
    const bool has_cells = !pane.parts.cells.empty();
    legend.has_cells |= has_cells;
    legend.has_straddlers |= has_cells && pane.parts.holding != Holding::inside;
    legend.has_lists |= !pane.parts.lists.empty();
    legend.has_rejected |= pane.parts.tells_tested;
  }
  return legend;
}

}  // namespace

template <int D>
struct PanesRenderer<D>::State {
  explicit State(const FrameOptions& chosen)
      : options(chosen),
        camera(parse_camera<D>(chosen.camera)),
        camera_path(chosen.camera_path),
        font(letter_height(chosen.height)),
        context(make_offscreen_context(chosen.backend)),
        painter(context->functions(), font) {
    for (Batch& batch : batches) batch.keeps_items = options.ids;
    overlay.shapes.keeps_items = options.ids;
    overlay.text.keeps_lines = options.ids;
  }
  ~State() { context->make_current(); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[nodiscard]] bool has(Layer layer) const { return options.layers.has(layer); }

  void choose_framebuffer(const PaneGrid& grid, int samples) {
    const std::array<int, 3> wanted{grid.width, grid.height, samples};
    if (wanted == pane_size) return;
    pane_framebuffer.emplace(context->functions(), grid.width, grid.height, samples);
    pane_size = wanted;
  }

  /// Title, gaps and legend.
  void draw_rim(const PanesFrame<D>& frame, const PanesLegend& legend, int above, int below) {
    const View view = flat_view(options.width, options.height);
    overlay.clear();
    const auto band = [&](int top, int height) {
      add_rectangle_on_picture(overlay.shapes, view, {0, double(top), double(options.width), double(height)},
                               palette::kPanel);
    };
    const int pad = flow::padding(font);
    if (above > 0) {
      band(0, above);
      int y = pad;
      for (const std::string& line : title_of(frame)) {
        overlay.text.add(font, pad, y, line, palette::kInk);
        y += font.line_height();
      }
    }
    if (below > 0) {
      band(options.height - below, below);
      draw_panes_legend(legend, view, font, options.height - below, scale(), overlay);
    }
    painter.draw(overlay.shapes, Depth::ignore);
    painter.draw(overlay.text, view);
    texts = overlay.text.lines;
  }

  [[nodiscard]] static View flat_view(int width, int height) {
    View view;
    view.clip_from_world = Eigen::Matrix4d::Identity();
    view.picture_width = width;
    view.picture_height = height;
    return view;
  }
  [[nodiscard]] double scale() const { return std::clamp(options.height / 720.0, 0.6, 8.0); }

  void draw_scene(const DrawContext<D>& drawn, const StructurePane<D>& pane) {
    for (Batch& batch : batches) batch.clear();
    auto& [back, glass, lines] = batches;
    if constexpr (D == 2) {
      if (has(Layer::leaves)) draw_cell_areas(drawn, pane.parts, back);
      if (has(Layer::objects)) draw_objects(drawn, back);
    } else {
      draw_space(drawn, {}, {back, glass, shadows});
    }
    if (has(Layer::partitioners)) draw_cell_outlines(drawn, pane.parts, glass);
    if (has(Layer::pairs)) draw_rejected<D>(drawn, pane.rejected, lines);
    draw_pairs(drawn, lines);
    if constexpr (D == 3) {
      painter.draw(back, Depth::test_and_write, Blend::replace);
      painter.draw(shadows, Depth::test, Blend::darken);
    } else {
      painter.draw(back, Depth::ignore);
    }
    for (const Batch* const rest : {&glass, &lines})
      painter.draw(*rest, D == 3 ? Depth::test : Depth::ignore);
  }

  /// What stands above the scene: the head with the pane's words, and lists along axes.
  void draw_overlay(const PanesFrame<D>& frame, const StructurePane<D>& pane, const View& view,
                    const Viewport& scene, const PaneGrid& grid) {
    overlay.clear();
    const auto fill = [&](const Viewport& box, Color color) {
      if (box.width > 0 && box.height > 0) add_rectangle_on_picture(overlay.shapes, view, box, color);
    };
    fill({0, 0, double(grid.width), scene.top}, palette::kPanel);
    // An aimed camera shows what lies below the strips, too.
    fill({0, scene.top, scene.left, scene.height}, palette::kGround);
    fill({0, scene.top + scene.height, double(grid.width), grid.height - scene.top - scene.height},
         palette::kGround);
    if (frame.has_strips)
      draw_axis_strips<D>(view, font, scene, frame.bounds, pane.parts.lists, frame.bodies, overlay);
    const int pad = flow::padding(font);
    const PaneLines lines = pane_lines(pane, frame.is_timed, room_of(grid));
    int y = pad;
    const auto write = [&](const std::vector<std::string>& words, Color color) {
      for (const std::string& line : words) {
        overlay.text.add(font, pad, y, line, color);
        y += font.line_height();
      }
    };
    if (has(Layer::caption)) {
      write(lines.plain, palette::kInk);
      write(lines.faint, palette::kFaintInk);
    }
    painter.draw(overlay.shapes, Depth::ignore);
    painter.draw(overlay.text, view);
  }

  [[nodiscard]] std::size_t letters(int width) const {
    return std::max<std::size_t>(1, font.letters(width - 2 * flow::padding(font)));
  }
  /// So many lines are a part of a height: the scene has the rest.
  [[nodiscard]] int most_lines(double part, int height) const {
    return std::max(1, static_cast<int>(part * height) / font.line_height());
  }
  [[nodiscard]] PaneRoom room_of(const PaneGrid& grid) const {
    constexpr double kHeadShare = 0.4;
    return {letters(grid.width), static_cast<std::size_t>(most_lines(kHeadShare, grid.height))};
  }
  [[nodiscard]] std::vector<std::string> title_of(const PanesFrame<D>& frame) const {
    return panes_title(frame, letters(options.width));
  }

  /// The same in all panes, so that one camera shows the same in each.
  [[nodiscard]] Viewport scene_of(const PanesFrame<D>& frame, const PaneGrid& grid) const {
    std::size_t lines = 0;
    for (const StructurePane<D>& pane : frame.panes)
      lines = std::max(lines, pane_lines(pane, frame.is_timed, room_of(grid)).size());
    const int head = has(Layer::caption) ? flow::band_height(font, static_cast<int>(lines)) : 0;
    const StripRoom room = frame.has_strips ? strip_room(D, font) : StripRoom{};
    return {room.left, double(head), grid.width - room.left, grid.height - head - room.bottom};
  }

  void draw_pane(const PanesFrame<D>& frame, const StructurePane<D>& pane, const Viewport& scene,
                 const PaneGrid& grid) {
    const View view =
        frame_all(frame.bounds, camera_path.at(frame.step, camera), scene, grid.width, grid.height);
    FrameInput<D> input;
    input.bodies = frame.bodies;
    input.pairs = pane.pairs;
    input.contacts = frame.contacts;
    const std::vector<Color> colors =
        has(Layer::leaves) ? object_colors<D>(pane.parts, frame.bodies) : std::vector<Color>();
    ids.list.clear();
    const DrawContext<D> drawn{input,
                               view,
                               no_tree,
                               no_placements,
                               frame.bounds,
                               D == 3 ? options.layers.with(Layer::leaves, false) : options.layers,
                               std::clamp(grid.height / 720.0, 0.6, 8.0),
                               kFullCell,
                               options.ids ? &ids.list : nullptr,
                               colors};
    pane_framebuffer->bind();
    painter.begin(palette::kGround);
    draw_scene(drawn, pane);
    draw_overlay(frame, pane, view, scene, grid);
  }

  /// Of a picture with one pane: its triangles again, in flat colours and with one sample a pixel.
  void draw_ids(const PaneGrid& grid) {
    Framebuffer flat(context->functions(), grid.width, grid.height, 1);
    flat.bind();
    painter.begin_ids();
    Batch id_batch;
    for (const Batch& batch : batches) {
      make_id_batch(batch, id_batch);
      const bool is_back = &batch == batches.data();
      painter.draw(id_batch, D == 2 ? Depth::ignore : is_back ? Depth::test_and_write : Depth::test);
    }
    make_id_batch(overlay.shapes, id_batch);
    painter.draw(id_batch, Depth::ignore);
    Image pane;
    flat.read(pane);
    measure_items(batches, grid.width, grid.height, ids.list);
    count_pixels(pane, ids.list);
    for (Drawn& item : ids.list.items) {
      item.top += static_cast<float>(grid.top);
      item.bottom += static_cast<float>(grid.top);
    }
    ids.image = make_image(options.width, options.height, 0x000000ffU);  // item 0 is the ground
    for (int y = 0; y < grid.height; ++y)
      std::memcpy(ids.image.rgba.data() + static_cast<std::size_t>(y + grid.top) * ids.image.stride(),
                  pane.pixel(0, y), pane.stride());
    ids.list.texts = texts;
    for (DrawnText line : overlay.text.lines) {
      line.y += grid.top;
      ids.list.texts.push_back(std::move(line));
    }
  }

  const Image& render(const PanesFrame<D>& frame) {
    if (!have_room(options.width, options.height, frame.panes.size()))
      throw std::invalid_argument("the panes have no room in the picture");
    context->make_current();
    const PanesLegend legend = legend_of(frame, options.layers);
    constexpr double kLegendShare = 0.22;
    const int above =
        has(Layer::caption) ? flow::band_height(font, static_cast<int>(title_of(frame).size())) : 0;
    const int legend_rows =
        std::min(legend_lines(legend, font, options.width), most_lines(kLegendShare, options.height));
    const int below = has(Layer::legend) ? flow::band_height(font, legend_rows) : 0;
    const int columns = frame.columns > 0 ? frame.columns
                                          : choose_columns(options.width, options.height, frame.panes.size(),
                                                           aspect_of(frame.bounds));
    const PaneGrid grid(static_cast<int>(frame.panes.size()), columns, options.width, options.height, above,
                        below);
    const Viewport scene = scene_of(frame, grid);
    if (!picture) picture.emplace(context->functions(), options.width, options.height, 1);
    choose_framebuffer(grid, frame.samples);
    picture->bind();
    painter.begin(kGap);
    draw_rim(frame, legend, above, below);
    for (std::size_t k = 0; k < frame.panes.size(); ++k) {
      draw_pane(frame, frame.panes[k], scene, grid);
      pane_framebuffer->copy_to(*picture, grid.left_of(k), grid.top_of(k));
    }
    picture->read(image);
    if (options.ids) draw_ids(grid);
    check_gl(context->functions(), "drawing panes");
    return image;
  }

  FrameOptions options;
  CameraChoice<D> camera;
  CameraPath<D> camera_path;
  Font font;
  std::unique_ptr<GlContext> context;
  std::optional<Framebuffer> picture;
  std::optional<Framebuffer> pane_framebuffer;
  std::array<int, 3> pane_size{};  ///< and its samples
  Painter painter;
  const TreeSnapshotOf<D> no_tree;
  const std::vector<Placement> no_placements;

  // Memory kept from pane to pane: the passes are back, glass and lines.
  std::array<Batch, 3> batches;
  Batch shadows;
  Overlay overlay;
  std::vector<DrawnText> texts;
  FrameIds ids;
  Image image;
};

template <int D>
PanesRenderer<D>::PanesRenderer(const FrameOptions& options) : state_(std::make_unique<State>(options)) {}

template <int D>
PanesRenderer<D>::~PanesRenderer() = default;

template <int D>
const Image& PanesRenderer<D>::render(const PanesFrame<D>& frame) {
  return state_->render(frame);
}

template <int D>
const FrameIds& PanesRenderer<D>::ids() const {
  return state_->ids;
}

template <int D>
std::string PanesRenderer<D>::rasterizer() const {
  return state_->context->rasterizer();
}

template class PanesRenderer<2>;
template class PanesRenderer<3>;

}  // namespace kerf
