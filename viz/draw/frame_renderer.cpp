#include "viz/draw/frame_renderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/base/given_names.h"
#include "viz/draw/camera_path.h"
#include "viz/draw/frame_planner.h"
#include "viz/draw/overlay.h"
#include "viz/draw/painter.h"
#include "viz/draw/palette.h"
#include "viz/draw/triad.h"
#include "viz/draw/wrong_pair_lines.h"
#include "viz/gl/context.h"
#include "viz/gl/framebuffer.h"

namespace kerf {
namespace {

const FrameOptions& checked(const FrameOptions& options) {
  const auto good = [](int side) { return side >= kMinFrameSide && side <= kMaxFrameSide; };
  if (!good(options.width) || !good(options.height)) {
    throw std::invalid_argument("a frame of " + std::to_string(options.width) + "x" +
                                std::to_string(options.height) +
                                " pixels cannot be drawn; each side can be " + std::to_string(kMinFrameSide) +
                                " to " + std::to_string(kMaxFrameSide));
  }
  const Margins& margins = options.margins;
  if (margins.left + margins.right >= options.width || margins.top + margins.bottom >= options.height)
    throw std::invalid_argument("the margins leave nothing of the picture to its scene");
  if (options.samples != 0 && options.samples != 1 && options.samples != 4)
    throw std::invalid_argument("a pixel can have 1 or 4 samples, or 0 for a choice, not " +
                                std::to_string(options.samples));
  return options;
}

template <int D>
std::string ramp_text(const FramePlan<D>& plan) {
  return std::to_string(plan.largest_population) + (plan.ramp_is_fixed ? "+" : "");
}

Layout within(const Margins& margins, Layout layout) {
  layout.scene.left += margins.left;
  layout.scene.top += margins.top;
  layout.scene.width -= margins.left + margins.right;
  layout.scene.height -= margins.top + margins.bottom;
  return layout;
}

/// When a frame is, for a camera that moves: by what an import calls the step.
double time_of(const Caption& caption) {
  const auto named = parse_step_time(caption.step_name);
  return named ? static_cast<double>(*named) : static_cast<double>(caption.step);
}

std::vector<Color> leaf_colors(const DrawContext<3>& context) {
  std::vector<Color> colors;
  for (const TreeSnapshot::Node& node : context.snapshot.nodes())
    colors.push_back(palette::population_color(node.population, context.largest_population));
  return colors;
}

/// A camera that the user has aimed need not show everything.
template <int D>
std::optional<std::uint32_t> told_outside(const FramePlan<D>& plan, const CameraChoice<D>& camera) {
  return plan.names_outside && !camera.is_aimed() ? std::optional(plan.outside) : std::nullopt;
}

}  // namespace

template <int D>
struct FrameRenderer<D>::State {
  explicit State(const FrameOptions& chosen)
      : options(checked(chosen)),
        camera(parse_camera<D>(chosen.camera)),
        camera_path(chosen.camera_path),
        planner(chosen.layers, chosen.samples, camera.framing),
        font(chosen.letters > 0 ? chosen.letters : font_pixels(chosen.height)),
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

  void choose_framebuffer(int wanted) {
    if (wanted == samples) return;
    framebuffer.emplace(context->functions(), options.width, options.height, wanted);
    samples = wanted;
  }

  /// The scene itself, one batch a pass.
  void draw_scene(const DrawContext<D>& frame, const std::vector<Highlight>& highlights) {
    for (Batch& batch : batches) batch.clear();
    Batch& back = batches[0];
    Batch& glass = batches[1];
    Batch& lines = batches[2];
    Batch& front = batches[3];
    if constexpr (D == 2) {
      if (has(Layer::leaves)) draw_leaves(frame, back);
      if (has(Layer::objects)) draw_objects(frame, back);
    } else {
      draw_space(frame, leaf_colors(frame), {back, glass, shadows});
    }
    if (has(Layer::partitioners)) draw_partitioners(frame, glass);
    draw_pairs(frame, lines);
    if (has(Layer::operators)) draw_highlights(frame.view, frame.line_scale, highlights, front, frame.list);
    if (has(Layer::pairs)) draw_errors(frame, front);
    if (tamper) tamper(batches, ids.list);
    if constexpr (D == 3) {
      painter.draw(back, Depth::test_and_write, Blend::replace);
      painter.draw(shadows, Depth::test, Blend::darken);
    } else {
      painter.draw(back, Depth::ignore);
    }
    paint_rest(batches);
  }

  static void draw_errors(const DrawContext<D>& frame, Batch& batch) {
    const FrameInput<D>& input = frame.input;
    const auto drawable = [&](std::span<const Pair> pairs) {
      return drawable_pairs<D>(pairs, input.bodies, {}, pairs.size());
    };
    draw_wrong_pairs<D>(frame, {input.bodies, drawable(input.missed), drawable(input.extra)}, batch);
  }

  void paint_rest(const std::array<Batch, 4>& passes) const {
    painter.draw(passes[1], D == 3 ? Depth::test : Depth::ignore);
    painter.draw(passes[2], D == 3 ? Depth::test : Depth::ignore);
    painter.draw(passes[3], Depth::ignore);
  }

  /// The same triangles again, in flat colours and with one sample a pixel.
  void draw_ids() {
    if (!id_framebuffer) id_framebuffer.emplace(context->functions(), options.width, options.height, 1);
    for (std::size_t i = 0; i < batches.size(); ++i) make_id_batch(batches[i], id_batches[i]);
    id_framebuffer->bind();
    painter.begin_ids();
    painter.draw(id_batches[0], D == 3 ? Depth::test_and_write : Depth::ignore);
    paint_rest(id_batches);
    make_id_batch(overlay.shapes, id_overlay);  // a label hides what lies below it
    painter.draw(id_overlay, Depth::ignore);
    id_framebuffer->read(ids.image);
    ids.list.texts = overlay.text.lines;
    measure_items(batches, options.width, options.height, ids.list);
    count_pixels(ids.image, ids.list);
  }

  void draw_overlay(const DrawContext<D>& frame, const Layout& layout,
                    const std::vector<CaptionItem>& caption, const std::vector<LegendItem>& legend,
                    const std::vector<Highlight>& newest) {
    overlay.clear();
    const double triad = D == 3 && has(Layer::legend) ? 1.8 * font.line_height() : 0;
    Layout above = layout;  // labels keep off the axes
    above.scene.height -= kTriadHeight * triad;
    if (has(Layer::operators)) draw_highlight_labels(frame.view, font, above, newest, overlay);
    const std::string log = log_line(font, options.width, frame.input.caption.note,
                                     has(Layer::operators) ? newest : std::vector<Highlight>{});
    draw_caption(frame.view, font, layout, caption, log, overlay);
    draw_legend(frame.view, font, layout, legend, frame.line_scale, overlay);
    if (triad > 0) draw_triad(frame.view, font, layout.scene, Corner::left, triad, overlay);
    if (sketch) sketch(frame.view, font, overlay);
    painter.draw(overlay.shapes, Depth::ignore);
    painter.draw(overlay.text, frame.view);
  }

  const Image& render(const FrameInput<D>& input, const FramePlan<D>& plan) {
    context->make_current();
    std::vector<CaptionItem> caption;
    const CameraChoice<D> now = camera_path.at(time_of(input.caption), camera);
    if (has(Layer::caption)) caption = caption_items(input.caption, plan.has_tree, told_outside(plan, now));
    std::vector<LegendItem> legend;
    if (has(Layer::legend))
      legend =
          legend_items(options.layers, D, plan.has_tree, ramp_text(plan), input.caption.theirs.has_value());
    const bool has_log = !caption.empty() && (has(Layer::operators) || !input.caption.note.empty());
    const Layout layout =
        within(options.margins, make_layout(font, options.width, options.height, caption, has_log, legend));
    const View view = frame_all(plan.bounds, now, layout.scene, options.width, options.height);
    const double line_scale = std::clamp(options.height / 720.0, 0.6, 8.0);
    const DrawContext<D> frame{input,
                               view,
                               plan.snapshot,
                               plan.placements,
                               plan.bounds,
                               options.layers,
                               line_scale,
                               plan.largest_population,
                               options.ids ? &ids.list : nullptr,
                               {},
                               plan.crowds};
    ids.list.clear();
    choose_framebuffer(plan.samples);
    framebuffer->bind();
    painter.begin(palette::kGround);
    draw_scene(frame, plan.highlights);
    draw_overlay(frame, layout, caption, legend, plan.highlights);
    framebuffer->read(image);
    if (options.ids) draw_ids();
    check_gl(context->functions(), "drawing a frame");
    return image;
  }

  FrameOptions options;
  CameraChoice<D> camera;
  CameraPath<D> camera_path;
  FramePlanner<D> planner;
  Font font;
  std::unique_ptr<GlContext> context;
  std::optional<Framebuffer> framebuffer;
  std::optional<Framebuffer> id_framebuffer;
  int samples = 0;  ///< of the framebuffer
  Painter painter;

  // Memory kept from frame to frame.
  std::array<Batch, 4> batches;
  std::array<Batch, 4> id_batches;
  Batch shadows;
  Batch id_overlay;
  FrameIds ids;
  Tamper tamper;
  Sketch sketch;
  Overlay overlay;
  Image image;
};

template <int D>
FrameRenderer<D>::FrameRenderer(const FrameOptions& options) : state_(std::make_unique<State>(options)) {}

template <int D>
FrameRenderer<D>::~FrameRenderer() = default;

template <int D>
FrameRenderer<D>::FrameRenderer(FrameRenderer&&) noexcept = default;

template <int D>
FrameRenderer<D>& FrameRenderer<D>::operator=(FrameRenderer&&) noexcept = default;

template <int D>
const Image& FrameRenderer<D>::render(const FrameInput<D>& input) {
  return state_->render(input, state_->planner.plan(input));
}

template <int D>
const Image& FrameRenderer<D>::render(const FrameInput<D>& input, const FramePlan<D>& plan) {
  return state_->render(input, plan);
}

template <int D>
void FrameRenderer<D>::set_view_box(const Box<D>& box) {
  state_->planner.fix_view_box(box);
}

template <int D>
void FrameRenderer<D>::set_layers(LayerSet layers) {
  state_->options.layers = layers;
  state_->planner.set_layers(layers);
}

template <int D>
void FrameRenderer<D>::set_camera(const CameraChoice<D>& camera) {
  state_->camera = camera;
}

template <int D>
void FrameRenderer<D>::set_sketch(Sketch sketch) {
  state_->sketch = std::move(sketch);
}

template <int D>
const FrameIds& FrameRenderer<D>::ids() const {
  return state_->ids;
}

template <int D>
std::string FrameRenderer<D>::rasterizer() const {
  return state_->context->rasterizer();
}

template <int D>
void FrameRenderer<D>::set_tamper(Tamper tamper) {
  state_->tamper = std::move(tamper);
}

template class FrameRenderer<2>;
template class FrameRenderer<3>;

}  // namespace kerf
