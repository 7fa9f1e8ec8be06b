"use strict";
// data: name, bodies (fixed, parts), runs (engine, frames, events), middle: the run that the others are compared with.
// A frame is [time, x, y, z, qx, qy, qz, qw of each body], an event [time, kind, a, b].
const KINDS = ["impact", "micro-collision", "completed", "contact", "release", "force"];
const element = id => document.getElementById(id);
const {runs, bodies} = data, main = runs[data.middle], events = main.events;
const first = main.frames.length ? main.frames[0][0] : 0;
const last = Math.max(first, ...runs.map(run => run.frames.length ? run.frames[run.frames.length - 1][0] : first));
const moving = bodies.map((body, b) => b).filter(b => !bodies[b].fixed);
const dark = matchMedia("(prefers-color-scheme: dark)");
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const replay = {time: first, playing: false, speed: 1};

// The last k with times[k] <= time, at least 0.
function before(list, time) {
  let low = 0, high = list.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle][0] <= time) low = middle; else high = middle;
  }
  return low;
}

// The pose of a body: between two frames it moves along a line and turns at a constant rate.
replay.pose = (body, time, {frames} = main) => {
  const k = before(frames, time), a = frames[k], b = frames[Math.min(k + 1, frames.length - 1)];
  const share = b[0] > a[0] ? Math.min(1, Math.max(0, (time - a[0]) / (b[0] - a[0]))) : 0, at = 1 + 7 * body;
  const quaternion = f => new THREE.Quaternion(f[at + 3], f[at + 4], f[at + 5], f[at + 6]).normalize();
  const turned = quaternion(a).slerp(quaternion(b), share);
  return {p: [0, 1, 2].map(i => a[at + i] + share * (b[at + i] - a[at + i])), q: turned};
};

// How far (m) a run's bodies are at most from those of the run in the middle.
replay.apart = (run, time) => moving.reduce((most, b) => {
  const p = replay.pose(b, time, run).p, q = replay.pose(b, time).p;
  return Math.max(most, Math.hypot(...p.map((x, i) => x - q[i])));
}, 0);

function geometry(part) {
  if (part.radius) return new THREE.SphereBufferGeometry(part.radius, 40, 24);
  if (part.half) return new THREE.BoxBufferGeometry(...part.half.map(h => 2 * h));
  const corners = [];
  for (const face of part.faces) {
    for (let k = 2; k < face.length; ++k) for (const v of [face[0], face[k - 1], face[k]]) corners.push(...part.vertices[v]);
  }
  const hull = new THREE.BufferGeometry();
  hull.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  hull.computeVertexNormals();
  return hull;
}

// Three great circles, which show the rotation of a ball.
function circles(radius) {
  const points = [], turn = k => 2 * Math.PI * k / 48;
  for (let axis = 0; axis < 3; ++axis) {
    for (let k = 0; k < 48; ++k) {
      for (const angle of [turn(k), turn(k + 1)]) {
        const point = [Math.cos(angle), Math.sin(angle), 0].map(x => 1.004 * radius * x);
        points.push(point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3]);
      }
    }
  }
  return new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
}

// A body's name, or else its number, on a plate that faces the camera.
function plate(body, index) {
  const canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
  const font = "600 44px system-ui, sans-serif";
  const text = (body.name || String(index)).slice(0, 24);
  pen.font = font;
  canvas.width = pen.measureText(text).width + 28;
  canvas.height = 60;
  pen.fillStyle = "rgba(255, 255, 255, 0.8)";
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.font = font;
  pen.fillStyle = "#1b2130";
  pen.fillText(text, 14, 45);
  const map = new THREE.CanvasTexture(canvas);
  map.minFilter = THREE.LinearFilter;
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({map, depthTest: false, sizeAttenuation: false}));
  sprite.center.set(0.5, -0.7);  // above the body
  sprite.userData.shape = canvas.width / canvas.height;
  return sprite;
}

// Neighbours in the list differ in hue and in lightness. Fixed bodies are transparent.
function solid(body, index) {
  const group = new THREE.Group();
  const hue = (index * 0.381966) % 1;
  for (const part of body.parts) {
    const shape = geometry(part);
    const paint = new THREE.MeshStandardMaterial({
      color: body.fixed ? 0x8a93a5 : new THREE.Color().setHSL(hue, 0.6, index % 2 ? 0.62 : 0.42), roughness: 0.7,
      flatShading: !part.radius, transparent: body.fixed, opacity: body.fixed ? 0.25 : 1, depthWrite: !body.fixed});
    const lines = part.radius ? circles(part.radius) : new THREE.EdgesGeometry(shape);
    const edges = new THREE.LineSegments(lines, new THREE.LineBasicMaterial({color: 0x30363f, transparent: true, opacity: 0.5}));
    const placed = new THREE.Group(), mesh = new THREE.Mesh(shape, paint);
    mesh.castShadow = !body.fixed;
    mesh.receiveShadow = true;
    placed.add(mesh, edges);
    placed.position.set(...part.p);
    placed.quaternion.set(...part.q).normalize();
    group.add(placed);
  }
  if (!body.fixed) group.add(plate(body, index));
  return group;
}

// The points of a body, or of its balls' boxes, in its own frame.
function corners(body) {
  const signs = [-1, 1].flatMap(x => [-1, 1].flatMap(y => [-1, 1].map(z => [x, y, z])));
  return body.parts.flatMap(part => {
    const q = new THREE.Quaternion(...part.q).normalize(), p = new THREE.Vector3(...part.p);
    const reach = part.half || [part.radius, part.radius, part.radius];
    const own = part.vertices || signs.map(sign => sign.map((s, i) => s * reach[i]));
    if (part.radius) q.set(0, 0, 0, 1);
    return own.map(v => new THREE.Vector3(...v).applyQuaternion(q).add(p));
  });
}

// The box around the moving bodies (around all, if none moves) at these times, in the run in the middle.
const points = bodies.map(corners);
function extent(at) {
  const box = new THREE.Box3();
  for (const b of moving.length ? moving : bodies.keys()) {
    const ball = bodies[b].parts.length == 1 && bodies[b].parts[0].radius;
    for (const time of at) {
      const {p, q} = replay.pose(b, time);
      if (ball) q.set(0, 0, 0, 1);
      for (const v of points[b]) box.expandByPoint(v.clone().applyQuaternion(q).add(new THREE.Vector3(...p)));
    }
  }
  return box;
}

const sphere_of = box => box.getBoundingSphere(new THREE.Sphere());

// A grid on the ground, which catches shadows: at the lowest point that a moving body comes to.
function ground(box, radius, cell) {
  const level = box.min.z - radius * (bodies.some(body => body.fixed) ? 0.002 : 0.5);
  const centre = box.getCenter(new THREE.Vector3()), count = 2 * Math.min(40, Math.ceil(3 * radius / cell));
  const side = count * cell, lines = new THREE.GridHelper(side, count, 0x808896, 0x808896);
  lines.material.transparent = true;
  lines.material.opacity = 0.35;
  lines.rotation.x = Math.PI / 2;
  lines.position.set(Math.round(centre.x / cell) * cell, Math.round(centre.y / cell) * cell, level);
  const floor = new THREE.Mesh(new THREE.PlaneBufferGeometry(side, side), new THREE.ShadowMaterial({opacity: 0.35}));
  floor.position.copy(lines.position);
  floor.receiveShadow = true;
  return [floor, lines];
}

function lights(around) {
  const sun = new THREE.DirectionalLight(0xffffff, 0.8), sky = new THREE.HemisphereLight(0xffffff, 0x777777, 0.75);
  const r = around.radius;
  sun.position.copy(around.center).add(new THREE.Vector3(1, -1.2, 4).multiplyScalar(r));
  sun.target.position.copy(around.center);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  Object.assign(sun.shadow.camera, {left: -2 * r, right: 2 * r, top: 2 * r, bottom: -2 * r, near: r / 10, far: 8 * r});
  sky.position.set(0, 0, 1);
  return [sun, sun.target, sky];
}

// Columns if they are wide enough, else rows, else both.
function columns(width, height) {
  const n = runs.length;
  if (width / n >= 0.45 * height) return n;
  return height / n >= 0.45 * width ? 1 : Math.ceil(Math.sqrt(n));
}

// One scene for each run, seen from one camera.
function stage() {
  const renderer = new THREE.WebGLRenderer({antialias: true}), view = element("view"), canvas = renderer.domElement;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = THREE.PCFSoftShadowMap;
  const whole = extent(Array.from({length: 33}, (_, k) => first + (last - first) * k / 32)), around = sphere_of(whole);
  const cell = 10 ** Math.round(Math.log10(around.radius / 4)), solids = bodies.map(solid);
  const stages = runs.map(run => {
    const scene = new THREE.Scene(), own = solids.map(group => group.clone());
    scene.add(...own, ...lights(around), ...ground(whole, around.radius, cell));
    return {scene, run, own};
  });
  const plates = stages.flatMap(({own}) => own.flatMap(group => group.children.filter(child => child.isSprite)));
  const camera = new THREE.PerspectiveCamera(35, 1, around.radius / 100, around.radius * 200);
  camera.up.set(0, 0, 1);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `the bodies as ${runs.map(run => run.engine).join(", ")} moves them`);
  canvas.tabIndex = 0;
  view.prepend(canvas);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.enableKeys = false;
  let shown = around;  // the sphere that the camera frames
  const cells = () => [...element("cells").children].map(div => div.getBoundingClientRect());
  const tangent = Math.tan(35 * Math.PI / 360);  // of half the camera's angle
  const draw = () => {
    const frame = canvas.getBoundingClientRect();
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    cells().forEach((rect, k) => {
      const place = [rect.left - frame.left, frame.bottom - rect.bottom, rect.width, rect.height];
      renderer.setViewport(...place);
      renderer.setScissor(...place);
      renderer.render(stages[k].scene, camera);
    });
  };
  const aim = sphere => {  // keeps the direction, and the part of the view that the sphere fills
    const offset = camera.position.clone().sub(controls.target).multiplyScalar(sphere.radius / shown.radius);
    const aside = controls.target.clone().sub(shown.center).multiplyScalar(sphere.radius / shown.radius);
    controls.target.copy(sphere.center).add(aside);
    camera.position.copy(controls.target).add(offset);
    shown = sphere;
    controls.update();
  };
  let filled = 1;  // the sine of the angle that the framed sphere fills
  const fit = () => {
    const count = columns(view.clientWidth, view.clientHeight);
    element("cells").style.gridTemplateColumns = `repeat(${count}, minmax(0, 1fr))`;
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(view.clientWidth, view.clientHeight, false);
    renderer.setClearColor(colour("--paper"));
    const [rect] = cells(), plate_height = 15 / rect.height * 2 * tangent;
    camera.aspect = rect.width / Math.max(rect.height, 1);
    camera.updateProjectionMatrix();
    const fills = Math.sin(Math.atan(tangent * Math.min(1, camera.aspect)));
    camera.position.sub(controls.target).multiplyScalar(filled / fills).add(controls.target);
    filled = fills;
    for (const sprite of plates) sprite.scale.set(plate_height * sprite.userData.shape, plate_height, 1);
  };
  controls.target.copy(around.center);
  camera.position.set(0.35, -0.87, 0.36).setLength(1.05 * around.radius).add(around.center);
  fit();
  controls.update();
  controls.addEventListener("change", draw);
  const refit = () => { fit(); draw(); };
  new ResizeObserver(refit).observe(view);
  dark.addListener(refit);
  element("labels").checked = moving.length <= 12;
  element("follow").checked = around.radius > 3 * sphere_of(extent([first])).radius;
  element("labels").addEventListener("change", () => replay.seek(replay.time));
  element("follow").addEventListener("change", event => {
    if (!event.target.checked) aim(around);
    replay.seek(replay.time);
  });
  replay.canvas = canvas;
  replay.turn = (right, up) => {
    const x_axis = new THREE.Vector3(1, 0, 0), offset = camera.position.clone().sub(controls.target);
    const from = new THREE.Spherical().setFromVector3(offset.applyAxisAngle(x_axis, -Math.PI / 2));  // z is up
    from.theta -= right;
    from.phi = Math.min(Math.PI - 0.01, Math.max(0.01, from.phi - up));
    camera.position.setFromSpherical(from).applyAxisAngle(x_axis, Math.PI / 2).add(controls.target);
    controls.update();
  };
  replay.zoom = factor => {
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    controls.update();
  };
  element("note").textContent += `, squares of ${+cell.toPrecision(1)} m`;
  return () => {
    if (element("follow").checked) aim(sphere_of(extent([replay.time])));
    for (const {run, own} of stages) {
      own.forEach((group, body) => {
        group.visible = run.frames.length > 0;
        if (!group.visible) return;
        const {p, q} = replay.pose(body, replay.time, run);
        group.position.set(...p);
        group.quaternion.copy(q);
      });
    }
    for (const sprite of plates) sprite.visible = element("labels").checked;
    draw();
  };
}

// Above each run its engine, and how far its bodies are from those of the run in the middle.
function name_runs() {
  const holder = document.createElement("div");
  holder.id = "cells";
  for (const run of runs) {
    const [cell, heading, state] = ["div", "h2", "span"].map(name => document.createElement(name));
    heading.textContent = run.engine;
    cell.append(heading, state);
    holder.append(cell);
    run.tell = () => {
      const end = run.frames.length ? run.frames[run.frames.length - 1][0] : null;
      if (end === null) state.textContent = "no answer";
      else if (replay.time > end) state.textContent = `ended at ${end} s`;
      else if (run !== main) state.textContent = `${+replay.apart(run, replay.time).toPrecision(2)} m off`;
      else state.textContent = "";
    };
  }
  element("view").append(holder);
}

// Ticks above the slider: impacts in one colour, resting contacts in another.
function mark() {
  const canvas = element("marks"), pen = canvas.getContext("2d");
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.clientHeight * devicePixelRatio;
  const colours = [colour("--impact"), colour("--rest")], seen = new Set();
  for (const [time, kind] of events) {
    const x = Math.round((time - first) / (last - first || 1) * (canvas.width - 2)), impact = kind === 0;
    if (seen.has(2 * x + impact)) continue;
    seen.add(2 * x + impact);
    pen.fillStyle = colours[impact ? 0 : 1];
    pen.fillRect(x, impact ? 0 : canvas.height / 2, 2, canvas.height / 2);
  }
}

document.querySelector("h1").textContent = data.name || "a scene";
element("note").textContent = `${bodies.length} bodies, ${last} s, ${events.length} events`;
let show = () => {};
const say = words => { element("view").innerHTML = `<p>${words}</p>`; };
if (main.frames.length) {
  name_runs();
  try {
    show = stage();
  } catch (error) {
    say("The bodies cannot be drawn: this browser gives no WebGL. Times and events are below.");
  }
} else {
  say("There is nothing to show.");
}

replay.seek = time => {
  replay.time = Math.min(last, Math.max(first, time));
  const latest = events.length && events[0][0] <= replay.time ? before(events, replay.time) + 1 : 0;
  element("scrub").value = last > first ? 1000 * (replay.time - first) / (last - first) : 0;
  const event = latest ? events[latest - 1] : null;
  element("now").textContent = `${replay.time.toPrecision(5)} s` + (events.length ? ` · event ${latest} of ${events.length}` : "") +
    (event ? ` (${KINDS[event[1]]})` : "");
  if (runs.length > 1) for (const run of runs) if (run.tell) run.tell();
  show();
};

replay.step = count => {
  const {frames} = main, k = before(frames, replay.time) + count;
  replay.seek(frames[Math.min(frames.length - 1, Math.max(0, k))][0]);
};

replay.event = forward => {
  const next = forward ? events.find(e => e[0] > replay.time) : events.filter(e => e[0] < replay.time).pop();
  if (next) replay.seek(next[0]);
};

replay.play = on => {
  if (on && replay.time >= last) replay.seek(first);
  replay.playing = on;
  element("play").textContent = on ? "Pause" : "Play";
  let then = performance.now();
  const tick = now => {
    if (!replay.playing) return;
    replay.seek(replay.time + replay.speed * Math.max(0, now - then) / 1000);
    then = now;
    if (replay.time >= last) replay.play(false); else requestAnimationFrame(tick);
  };
  if (on) requestAnimationFrame(tick);
};

const keys = {" ": () => replay.play(!replay.playing), ArrowRight: () => replay.step(1), ArrowLeft: () => replay.step(-1),
  n: () => replay.event(true), p: () => replay.event(false), Home: () => replay.seek(first), End: () => replay.seek(last)};
const camera_keys = {ArrowLeft: () => replay.turn(-0.15, 0), ArrowRight: () => replay.turn(0.15, 0),
  ArrowUp: () => replay.turn(0, 0.15), ArrowDown: () => replay.turn(0, -0.15),
  "+": () => replay.zoom(0.9), "=": () => replay.zoom(0.9), "-": () => replay.zoom(1 / 0.9)};
addEventListener("keydown", event => {
  const of_camera = replay.turn && (event.shiftKey || event.key.length === 1) && camera_keys[event.key];
  const act = of_camera || keys[event.key] || keys[event.key.toLowerCase()];
  if (!act || event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
  if (event.key === " " && (event.target.tagName === "BUTTON" || event.target.type === "checkbox")) return;
  event.preventDefault();
  act();
});
element("scrub").addEventListener("input", event => replay.seek(first + (last - first) * event.target.value / 1000));
element("play").addEventListener("click", () => replay.play(!replay.playing));
element("on").addEventListener("click", () => replay.event(true));
element("back").addEventListener("click", () => replay.event(false));
element("speed").addEventListener("change", event => { replay.speed = Number(event.target.value); });
addEventListener("resize", mark);
dark.addListener(mark);
mark();
replay.seek(first);
