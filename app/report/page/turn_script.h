// The script that turns the second view of a picture: by mouse, touch and arrow keys. It projects the coordinates that
// app/report/page/picture.cpp writes beside that view's elements. On paper and without it the view is from the front.
#pragma once

namespace touchstone::app {

inline constexpr const char* turn_script = R"js(
const turns = new WeakMap();  // picture -> {yaw, pitch}, in degrees

function hull(points) {
  const right = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) <= (b[1] - a[1]) * (c[0] - a[0]);
  const chain = list => list.reduce((to, p) => {
    while (to.length > 1 && right(to.at(-2), to.at(-1), p)) to.pop();
    return [...to, p];
  }, []);
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  return chain(sorted).concat(chain(sorted.reverse()));
}

function arrow([[x, y], [to_x, to_y]]) {
  const length = Math.hypot(to_x - x, to_y - y);
  if (length < 1) return '';
  const u = 6 * (to_x - x) / length, v = 6 * (to_y - y) / length;
  return `M${to_x - u + v / 2} ${to_y - v - u / 2}L${to_x} ${to_y}L${to_x - u - v / 2} ${to_y - v + u / 2}`;
}

function place(e, at) {
  const set = values => { for (const [name, value] of Object.entries(values)) e.setAttribute(name, value); };
  const line = (a, b) => `M${a}L${b}`;
  const [x, y] = at[e.dataset.end ?? 0];
  if (e.tagName == 'text') set({x, y});
  if (e.tagName == 'circle') set({cx: x, cy: y});
  if (e.tagName == 'polygon') set({points: hull(at).join(' ')});
  if (e.tagName != 'path') return;
  const ends = (e.dataset.edges ?? '0 1').split(' ');
  let d = '';
  for (let k = 0; k < ends.length; k += 2) d += line(at[ends[k]], at[ends[k + 1]]);
  set({d: e.classList.contains('arrow') ? d + arrow(at) : d});
}

function turn(svg, yaw, pitch) {
  turns.set(svg, {yaw, pitch: pitch = Math.max(-90, Math.min(90, pitch))});
  const [c, s, up, over] = [Math.cos, Math.sin].flatMap(f => f(yaw * Math.PI / 180))
      .concat([Math.cos, Math.sin].map(f => f(pitch * Math.PI / 180)));
  const view = svg.querySelector('.front');
  let far = 0;
  for (const e of view.querySelectorAll('[data-at]')) {
    const points = e.dataset.at.split(' ').map(p => p.split(',').map(Number));
    for (const p of points) far = Math.max(far, Math.hypot(...p));
    const at = points.map(([x, y, z]) => [c * x + s * y, -up * z - over * (c * y - s * x)].map(v => +v.toFixed(2)));
    for (const part of e.tagName == 'g' ? e.children : [e]) place(part, at);
  }
  const shrink = yaw || pitch ? Math.min(1, 85 / far) : 1;  // a corner must not leave the view
  view.setAttribute('transform', `translate(270 90) scale(${shrink})`);
  const angles = `turned by ${Math.round(yaw)}°, ${Math.round(pitch)}°`;
  svg.lastElementChild.textContent = yaw || pitch ? angles : svg.dataset.title;
}

const turn_by = (svg, yaw, pitch) => turn(svg, turns.get(svg).yaw + yaw, turns.get(svg).pitch + pitch);

for (const svg of document.querySelectorAll('svg.turns')) {
  turns.set(svg, {yaw: 0, pitch: 0});
  svg.dataset.title = svg.lastElementChild.textContent += ': drag to turn';
  svg.ariaLabel += '; arrow keys turn the view from the front, Home turns it back';
  svg.tabIndex = 0;
}

const picture_of = event => event.target.closest?.('svg.turns');
addEventListener('pointerdown', event => {
  const svg = picture_of(event);
  if (!svg || event.button) return;
  svg.setPointerCapture(event.pointerId);
});
addEventListener('pointermove', event => {
  const svg = picture_of(event);
  if (svg?.hasPointerCapture(event.pointerId)) turn_by(svg, -event.movementX / 2, event.movementY / 2);
});
const steps = {ArrowLeft: [10, 0], ArrowRight: [-10, 0], ArrowUp: [0, -10], ArrowDown: [0, 10]};
addEventListener('keydown', event => {
  const svg = picture_of(event);
  if (!svg || event.altKey || event.ctrlKey || event.metaKey || !(event.key in steps || event.key == 'Home')) return;
  event.preventDefault();
  if (event.key == 'Home') turn(svg, 0, 0); else turn_by(svg, ...steps[event.key]);
});
addEventListener('beforeprint', () => {
  for (const svg of document.querySelectorAll('svg.turns')) {
    if (turns.get(svg).yaw || turns.get(svg).pitch) turn(svg, 0, 0);
  }
});
)js";

}  // namespace touchstone::app
