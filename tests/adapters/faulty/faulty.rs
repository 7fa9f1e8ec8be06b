//! An adapter whose queries go wrong, each in its own way.
mod touchstone_adapter;
use touchstone_adapter::{abstains, object, serve, text, vector, Json, No};

fn bounds(scene: &Json) -> Result<Json, No> {
    println!("an engine that prints");
    let p = scene.get("bodies").list()[0].get("X_WB").get("p").vec3();
    Ok(Json::List(vec![object(vec![("lo", vector(&p)), ("hi", vector(&p))])]))
}

fn distance(_: &Json) -> Result<Json, No> { abstains("not today") }

fn mass(_: &Json) -> Result<Json, No> {
    Ok(Json::List(vec![object(vec![("mass", Json::Number(1.0)), ("p_BBcm", vector(&[0.0, f64::NAN, 0.0]))])]))
}

fn penetration(_: &Json) -> Result<Json, No> { panic!("the engine {}", "failed") }

fn pixel(_: &Json) -> Result<Json, No> { Err(No::Refuses("no compounds".into())) }

fn main() {
    let card = vec![("name", text("faulty")), ("version", text("1")), ("precision", text("binary32"))];
    serve(card, &[("mass", mass), ("bounds", bounds), ("distance", distance), ("penetration", penetration), ("pixel", pixel)],
          &[("mass", |scene| format!("ask about \"{}\"", scene.get("bodies").list().len()))]);
}
