//! An adapter of NAME for Touchstone. Build and run it by
//!     cargo build --release && touchstone adapter check "exec:target/release/NAME"
//! It answers the distance of two balls, and abstains from all else. Replace the parts that are marked TODO.
mod touchstone_adapter;
use touchstone_adapter::{abstains, object, serve, text, vector, Json, No};

/// TODO: make your engine's shape of the body's. Mind what your engine calls radius, half extents and sides:
/// {"type": "sphere", "radius"}, {"type": "box", "half_extents"}: a box has the sides 2 hx, 2 hy, 2 hz;
/// {"type": "polytope", "vertices", "faces"}: its faces are counter-clockwise seen from outside.
fn shape_of(body: &Json) -> Result<f64, No> {
    match body.get("shape").get("type").text() {
        "sphere" => Ok(body.get("shape").get("radius").number()),
        _ => abstains("balls only"),
    }
}

/// The distance of bodies 0 (A) and 1 (B). A pose X_WB maps points of the body's frame B to the world's frame W:
/// p_WQ = R(q) p_BQ + p. q = {w, x, y, z} may have any length but 0: divide it by its length if your engine needs that.
fn distance(scene: &Json) -> Result<Json, No> {
    let [a, b] = [0, 1].map(|i| &scene.get("bodies").list()[i]);
    let (r_a, r_b) = (shape_of(a)?, shape_of(b)?);
    let [p_wa, p_wb] = [a, b].map(|body| body.get("X_WB").get("p").vec3());
    // TODO: ask your engine here. Do not repair its answer: no clamping, no epsilon, no second try.
    let between: [f64; 3] = std::array::from_fn(|i| p_wa[i] - p_wb[i]);
    let length = between[0].hypot(between[1]).hypot(between[2]);
    let gap = length - r_a - r_b;
    if gap <= 0.0 {
        return Ok(object(vec![("verdict", text("overlapping")), ("distance", Json::Number(0.0))]));
    }
    let nhat_ba_w = between.map(|x| x / length); // all positions and directions of answers are in the world's frame W
    let p_wca: [f64; 3] = std::array::from_fn(|i| p_wa[i] - r_a * nhat_ba_w[i]); // what you do not know is left out
    let p_wcb: [f64; 3] = std::array::from_fn(|i| p_wb[i] + r_b * nhat_ba_w[i]);
    Ok(object(vec![
        ("verdict", text("separated")),
        ("distance", Json::Number(gap)),
        ("p_WCa", vector(&p_wca)),
        ("p_WCb", vector(&p_wcb)),
    ]))
}

fn main() {
    // TODO: the name and version of your engine; "binary32" if it computes in floats; which settings you use; a function
    // for each query that it answers: mass, bounds, broad_phase, pair_history, distance, penetration, impulse, pixel,
    // time_of_impact, simulation, constraint. Queries that are not here are never asked.
    let card = vec![("name", text("NAME")), ("version", text("0")), ("precision", text("binary64")),
                    ("about", text("closed form; a skeleton"))];
    serve(card, &[("distance", distance)], &[]); // the last: snippets, see docs/protocol.md
}
