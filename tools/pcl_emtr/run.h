#pragma once

namespace cli {

/// Reads the command line and two clouds, registers them, writes the outputs, and returns the exit
/// code; or does so for many pairs. Throws Failure.
int run(int argc, char** argv);

}  // namespace cli
