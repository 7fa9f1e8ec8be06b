#include "app/commands/import.h"

#include <filesystem>

#include "app/system/terminal.h"
#include "model/json.h"
#include "reference/mesh.h"

namespace touchstone::app {

void import_mesh(const std::string& mesh_path, const std::string& out) {
  Body body;
  body.name = mesh_path == "-" ? "stdin" : std::filesystem::path(mesh_path).stem().string();
  body.shape = reference::read_mesh(mesh_path);
  Scene scene;
  scene.name = body.name;
  scene.bodies.push_back(std::move(body));
  const std::string text = text_of(json_of(scene));
  if (out.empty()) {
    print_lines(text);
    return;
  }
  write_text(out, text);
  const auto& hull = std::get<Polytope>(scene.bodies[0].shape);
  print("{}: the convex hull, {} vertices, {} faces\n", out, hull.vertices.size(), hull.faces.size());
}

}  // namespace touchstone::app
