// The text of the replay page: app/motion/replay.html and app/motion/replay.js, embedded in the program by CMake.
#pragma once

namespace touchstone::app {

extern const char* const replay_html;
extern const char* const replay_script;

}  // namespace touchstone::app
