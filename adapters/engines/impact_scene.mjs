// The impact of a scene's contact as a motion, for an engine that cannot be asked for one
// (docs/how_to/add_a_subject.md).
import { Abstain, add, cross, inBody, inWorld, norm, scaled, sub } from "../js/touchstone_adapter.mjs";

const fixed = (body) => body.mass?.type === "fixed";

// Newton's law, or an impact on which all laws agree: one without friction or restitution, or of balls.
function requireNewton({ bodies, contact: { law = "poisson", restitution, friction, p_WC, nhat_BA_W } }) {
  if (friction === "sticking") throw new Abstain("an engine has no infinite friction");
  const through = (body) => fixed(body) || norm(cross(sub(p_WC, inWorld(body.X_WB, body.mass?.p_BBcm ?? [0, 0, 0])),
    nhat_BA_W)) === 0;
  const round = ({ shape, mass }) => shape.type === "sphere" || mass?.type === "fixed";
  const agree = restitution === 0 || friction === 0 || bodies.every((body) => round(body) && through(body));
  if (law !== "newton" && !agree) throw new Abstain("restitution is by Newton's law");
}

/**
 * A scene whose bodies are balls of radius 1 that are tangent at C, with the mass properties of the contact's bodies,
 * and both with its coefficients. `massOf(body)`: by the engine, of one with a density. By default the balls
 * overlap (m), so that no rounding parts them, and a step is so short (s) that nothing moves.
 */
export function impactScene(scene, massOf, { overlap = 2 ** -13, seconds } = {}) {
  if (!scene.contact) throw new Abstain("no contact");
  requireNewton(scene);
  const { p_WC, nhat_BA_W, restitution, friction } = scene.contact;
  const n = scaled((1 - overlap / 2) / norm(nhat_BA_W), nhat_BA_W);
  const speeds = scene.bodies.flatMap(({ velocity: { v_WBcm = [0], w_WB = [0] } = {} }) => [norm(v_WBcm), norm(w_WB)]);
  const bodies = scene.bodies.map((body, i) => {
    const centre = { p: inBody(body.X_WB, add(p_WC, scaled(i === 0 ? 1 : -1, n))), q: { w: 1, x: 0, y: 0, z: 0 } };
    const mass = fixed(body) || body.mass?.type === "given" ? body.mass : { type: "given", ...massOf(body) };
    return { ...body, mass, material: { restitution, friction },
      shape: { type: "compound", parts: [{ shape: { type: "sphere", radius: 1 }, X_BP: centre }] } };
  });
  return { bodies, motion: { sample_times: [seconds ?? 2 ** -30 / Math.max(1, ...speeds)] } };
}

/** The velocities after. */
export const after = ({ states: [states] }) => ({ after: states.map(({ velocity }) => velocity) });
