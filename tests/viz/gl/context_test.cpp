#include "viz/gl/context.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/viz/message_of.h"
#include "viz/gl/framebuffer.h"

namespace kerf {
namespace {

TEST(GlContext, IsModernEnoughAndSaysWhatItIs) {
  const auto context = make_offscreen_context();
  GLint major = 0;
  context->functions().GetIntegerv(GL_MAJOR_VERSION, &major);
  EXPECT_GE(major, 3);
  EXPECT_THAT(context->description(), testing::HasSubstr("OSMesa"));
}

TEST(GlContext, ErrorsAreNamedWithTheirPlace) {
  const auto context = make_offscreen_context();
  EXPECT_NO_THROW(check_gl(context->functions(), "the beginning"));
  context->functions().Enable(0xffff);
  const std::string error =
      test::message_of<std::runtime_error>([&] { check_gl(context->functions(), "the middle"); });
  EXPECT_THAT(error, testing::HasSubstr("the middle"));
  EXPECT_THAT(error, testing::HasSubstr("GL_INVALID_ENUM"));
}

TEST(Framebuffer, GivesBackWhatIsInIt) {
  const auto context = make_offscreen_context();
  const GlFunctions& gl = context->functions();
  for (const int samples : {1, 4}) {
    const Framebuffer framebuffer(gl, 40, 30, samples);
    framebuffer.bind();
    gl.ClearColor(1, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    Image image;
    framebuffer.read(image);
    EXPECT_EQ(image, make_image(40, 30, 0xff0000ff)) << samples << " samples";
    check_gl(gl, "the test");
  }
}

TEST(Framebuffer, TwoContextsDoNotMix) {
  const auto first = make_offscreen_context();
  const Framebuffer red(first->functions(), 8, 8, 1);
  red.bind();
  first->functions().ClearColor(1, 0, 0, 1);
  first->functions().Clear(GL_COLOR_BUFFER_BIT);
  {
    const auto second = make_offscreen_context();
    const Framebuffer blue(second->functions(), 8, 8, 1);
    blue.bind();
    second->functions().ClearColor(0, 0, 1, 1);
    second->functions().Clear(GL_COLOR_BUFFER_BIT);
  }
  first->make_current();
  Image image;
  red.read(image);
  EXPECT_EQ(image, make_image(8, 8, 0xff0000ff));
}

/// EGL is there wherever the tests run in full; elsewhere the reason is given.
std::unique_ptr<GlContext> egl_or_none(std::string& reason) {
  try {
    return make_offscreen_context(GlBackend::egl);
  } catch (const std::runtime_error& error) {
    reason = error.what();
    return nullptr;
  }
}

TEST(GlContext, EglAndOsmesaWorkSideBySide) {
  std::string reason;
  const auto egl = egl_or_none(reason);
  if (!egl) GTEST_SKIP() << reason;
  const auto osmesa = make_offscreen_context(GlBackend::osmesa);
  EXPECT_THAT(egl->description(), testing::HasSubstr("llvmpipe"));
  for (const std::uint32_t color : {0xff0000ffU, 0x00ff00ffU}) {
    for (GlContext* const context : {egl.get(), osmesa.get()}) {
      context->make_current();
      const Framebuffer framebuffer(context->functions(), 8, 8, 1);
      framebuffer.bind();
      context->functions().ClearColor(color == 0xff0000ffU ? 1 : 0, color == 0xff0000ffU ? 0 : 1, 0, 1);
      context->functions().Clear(GL_COLOR_BUFFER_BIT);
      Image image;
      framebuffer.read(image);
      EXPECT_EQ(image, make_image(8, 8, color)) << context->description();
    }
  }
}

TEST(GlContext, BackendsHaveNames) {
  EXPECT_EQ(parse_gl_backend("any"), GlBackend::any);
  EXPECT_EQ(parse_gl_backend("egl"), GlBackend::egl);
  EXPECT_EQ(parse_gl_backend("osmesa"), GlBackend::osmesa);
  EXPECT_THROW((void)parse_gl_backend("metal"), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
