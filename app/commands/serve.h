// Exact answers as a service: the messages of docs/protocol.md on stdin and stdout.
#pragma once

namespace touchstone::app {

/// Answers until `stop` or the end of stdin. The result of an answer is what `touchstone ask QUERY SCENE --json`
/// prints. Returns the exit code: 0, or nothing_reads_exit_code. Throws OutputError.
int serve();

}  // namespace touchstone::app
