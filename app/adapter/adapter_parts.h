// The texts of adapters/, embedded in the program by CMake.
#pragma once

namespace touchstone::app {

/// The library on which adapters in a language are built, and an adapter on it in which NAME stands for its name.
struct AdapterParts {
  const char* library;
  const char* skeleton;
};

extern const AdapterParts js_parts;
extern const AdapterParts python_parts;
extern const AdapterParts rust_parts;
extern const AdapterParts cpp_parts;

}  // namespace touchstone::app
