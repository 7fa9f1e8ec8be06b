// Speaks Touchstone's protocol (docs/protocol.md) for an adapter, which supplies a card and one function a query.
//
//   serve({ name: "my_engine", version: "1.0", precision: "binary64" }, { distance });
//
// A function gets a scene (docs/scene.schema.json) and returns the result (docs/protocol.schema.json), or a promise of it.
// It throws an Abstain if it does not answer this scene, and a Refused if the engine itself says that it does not take
// this scene; anything else that it throws is reported as a failure of the engine, and the next question follows.
// Import this file before the engine: some engines print while they load.
import { writeSync } from "node:fs";
import { createInterface } from "node:readline";

// What the engine or a library prints goes to stderr, and spoils no answer.
process.stdout.write = process.stderr.write.bind(process.stderr);
console.log = console.info = console.debug = console.error;

/** This scene is not answered; the message says why. */
export class Abstain extends Error {}

/** The engine says that it does not take this scene; the message is its reason. */
export class Refused extends Error {}

/** The engine computed NaN or an infinity, which JSON cannot hold; the message says where. */
class NotFinite extends Error {}

export const add = (a, b) => a.map((x, i) => x + b[i]);
export const sub = (a, b) => a.map((x, i) => x - b[i]);
export const scaled = (s, a) => a.map((x) => s * x);
export const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = (a) => Math.hypot(...a);

/** The quaternion of length 1 with the rotation of q, which has any length but 0, however large or small. */
export function unitQuaternion(q) {
  const largest = Math.max(...[q.w, q.x, q.y, q.z].map(Math.abs));
  const part = [q.w, q.x, q.y, q.z].map((c) => c / largest);
  const [w, x, y, z] = scaled(1 / norm(part), part);
  return { w, x, y, z };
}

/** R(q) v: a vector of the body's frame B, in the world's frame W. */
export function rotated(q, v) {
  const { w, x, y, z } = unitQuaternion(q);
  const t = scaled(2, cross([x, y, z], v));
  return add(add(v, scaled(w, t)), cross([x, y, z], t));
}

/** The point of the body's frame B, in the world's frame W: R(q) p_BQ + p. */
export const inWorld = (pose, p_BQ) => add(rotated(pose.q, p_BQ), pose.p);

/** The point of the world's frame W, in the body's frame B: the inverse of inWorld. */
export const inBody = (pose, p_WQ) => rotated({ ...pose.q, w: -pose.q.w }, sub(p_WQ, pose.p));

/** Typed arrays become lists. A number that is not finite throws; JSON.stringify would silently write null. */
function plain(value, place) {
  if (typeof value === "number" && !Number.isFinite(value)) {
    throw new NotFinite(`${place} is ${String(value).replace("I", "i")}`);
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    return Array.from(value, (part, i) => plain(part, `${place}[${i}]`));
  }
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, part]) => [key, plain(part, `${place}.${key}`)]));
}

/** A line before a program, whose imports come first wherever they stand; so it is printed even if the engine throws. */
const printed = (expected) => `console.log("expected:", ${JSON.stringify(expected)});\n`;

async function answer(message, card, queries, snippets) {
  if (message.op === "start") return { protocol: 1, card };
  if (typeof message.query !== "string") throw new Error("query: missing");
  if (message.op === "reproduce") {
    if (!(message.query in snippets)) return { abstains: `no snippets of ${message.query}` };
    const program = await snippets[message.query](message.scene);
    return { snippet: message.expected ? `${printed(message.expected)}${program}` : program };
  }
  if (!(message.query in queries)) return { abstains: `no ${message.query} query` };
  return { result: plain(await queries[message.query](message.scene), "result") };
}

function breaks(error) {
  if (error instanceof Abstain) return { abstains: error.message };
  const kind = error instanceof NotFinite ? "garbage" : error instanceof Refused ? "refused" : "threw";
  return { breaks: { kind, how: kind === "threw" ? String(error) : error.message } };
}

function writeAll(line) {
  const bytes = Buffer.from(line);
  for (let done = 0; done < bytes.length; ) {
    try {
      done += writeSync(1, bytes, done);
    } catch (error) {
      if (error.code !== "EAGAIN") throw error; // the judge has not read the pipe yet
    }
  }
}

/**
 * Answers until `stop` or the end of stdin. `queries`: name -> function of a scene. `snippets`: name of a query -> function
 * of a scene that returns a program in the engine's own API, as the text of a module, which asks the engine the same. What
 * the answer should be is printed before it.
 */
export async function serve(card, queries, snippets = {}) {
  const whole = { ...card, answers: Object.keys(queries), reproduces: Object.keys(snippets) };
  for await (const line of createInterface({ input: process.stdin, crlfDelay: Infinity })) {
    let seq = 0;
    let said;
    try {
      const message = JSON.parse(line);
      seq = message.seq;
      if (message.op === "stop") break;
      said = await answer(message, whole, queries, snippets);
    } catch (error) {
      said = breaks(error);
    }
    writeAll(JSON.stringify({ seq, ...said }) + "\n");
  }
  process.exit(0); // an engine's timers or workers must not keep the process
}
