// The replay page's own text: app/replay.html and app/replay.js, made part of the program by CMake.
#pragma once

namespace touchstone::app {

extern const char* const replay_html;
extern const char* const replay_script;

}  // namespace touchstone::app
