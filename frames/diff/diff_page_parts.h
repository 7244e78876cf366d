#pragma once

#include <string_view>

namespace kerf {

/// Beginning and end of the page: style and behaviour. Nothing is fetched from anywhere.
inline constexpr std::string_view kDiffPageHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>kerf diff</title><link rel="icon" href="data:,">
<style>
body{margin:0 auto;max-width:1900px;padding:1.5rem;font:16px/1.5 system-ui,sans-serif;color:#191919;background:#fafaf7}
h1{font-size:1.5rem;margin-bottom:.2rem}.sub{color:#555;margin-top:0}
section{margin-top:2.5rem;border-top:2px solid #0072b2}h2{font-size:1.2rem}
code{background:#eeeee9;padding:.3rem .6rem;border-radius:3px;user-select:all}
.trouble{color:#b00020;font-weight:bold}ul{max-height:14rem;overflow-y:auto;margin:.5rem 0}
.panels,.lenses{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(420px,100%),1fr));gap:.6rem}
.lenses{margin-top:.6rem}.lenses[hidden]{display:none}
figure{margin:0}figcaption{color:#555;font-size:.85rem}
img{display:block;width:100%;border:1px solid #d8d8d2;cursor:crosshair;box-sizing:border-box}
img[hidden]{display:none}.under{margin:.4rem 0;color:#555;font-size:.85rem}
.lens{height:180px;border:1px solid #d8d8d2;overflow:hidden;position:relative;image-rendering:pixelated;background-repeat:no-repeat}
.lens::after{content:"";position:absolute;left:50%;top:50%;width:8px;height:8px;margin:-4px;outline:1px solid #d00060}
button{font:inherit;font-size:.85rem;border:1px solid #c8c8c2;background:#fff;border-radius:3px;cursor:pointer}
</style></head><body>
)";

inline constexpr std::string_view kDiffPageFoot = R"(<script>
const kZoom = 8;
// The numbers of the items at each pixel, of the reference and of the new picture.
function itemsOf(section) {
  section.items ??= [...section.querySelectorAll("img[data-names]")].map(image => {
    const canvas = document.createElement("canvas");
    const width = canvas.width = image.naturalWidth, height = canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, width, height).data;
    return {side: image.alt, names: JSON.parse(image.dataset.names), width, pixels};
  });
  return section.items;
}
function nameAt({side, names, width, pixels}, x, y) {
  const at = 4 * (y * width + x);
  const item = pixels[at] * 65536 + pixels[at + 1] * 256 + pixels[at + 2];
  return `${side} ${item === 0 ? "ground" : names[item]}`;
}
function sayWhatIsAt(section, x, y) {
  const under = section.querySelector(".under");
  if (!under) return;
  const names = itemsOf(section).map(items => nameAt(items, x, y));
  under.textContent = `(${x}, ${y}): ${names.join(", ")}`;
}
function showLenses(section, x, y) {
  const lenses = section.querySelector(".lenses");
  const images = [...section.querySelectorAll(".panels img")];
  lenses.hidden = false;
  while (lenses.children.length < images.length) {
    const lens = document.createElement("div");
    lens.className = "lens";
    lenses.append(lens);
  }
  images.forEach((image, i) => {
    const lens = lenses.children[i];
    const source = `url("${image.dataset.own || image.src}")`;
    if (lens.dataset.set !== "yes") { lens.style.backgroundImage = source; lens.dataset.set = "yes"; }
    lens.style.backgroundSize = `${image.naturalWidth * kZoom}px ${image.naturalHeight * kZoom}px`;
    const left = lens.clientWidth / 2 - (x + 0.5) * kZoom, top = lens.clientHeight / 2 - (y + 0.5) * kZoom;
    lens.style.backgroundPosition = `${left}px ${top}px`;
    lens.title = `(${x}, ${y})`;
  });
  sayWhatIsAt(section, x, y);
}
for (const section of document.querySelectorAll("section")) {
  for (const image of section.querySelectorAll(".panels img")) {
    image.addEventListener("mousemove", event => {
      const box = image.getBoundingClientRect();
      const at = (place, size, pixels) => Math.max(0, Math.min(pixels - 1, Math.floor(place / size * pixels)));
      showLenses(section, at(event.clientX - box.left, box.width, image.naturalWidth),
                 at(event.clientY - box.top, box.height, image.naturalHeight));
    });
  }
  for (const button of section.querySelectorAll("button[data-x]"))
    button.addEventListener("click", () => showLenses(section, +button.dataset.x, +button.dataset.y));
  const changing = section.querySelector(".new img"), reference = section.querySelector(".reference img");
  if (!changing || !reference) continue;
  changing.dataset.own = changing.src;
  const caption = section.querySelector(".new figcaption"), words = caption.textContent;
  const swap = on => {
    changing.src = on ? reference.src : changing.dataset.own;
    caption.textContent = on ? "reference, while pointed at" : words;
  };
  changing.tabIndex = 0;
  for (const begin of ["mouseenter", "focus"]) changing.addEventListener(begin, () => swap(true));
  for (const end of ["mouseleave", "blur"]) changing.addEventListener(end, () => swap(false));
}
</script></body></html>
)";

}  // namespace kerf
