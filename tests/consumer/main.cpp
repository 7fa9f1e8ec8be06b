#include <model/json.h>
#include <reference/distance.h>
#include <reference/validity.h>

#include <iostream>

int main(int, char** arguments) {
  using namespace touchstone;
  const Scene scene = reference::completed(read_scene(arguments[1]));
  const reference::DistanceTruth truth = reference::distance(scene);
  std::cout << truth.core_squared.text() << '\n';
}
