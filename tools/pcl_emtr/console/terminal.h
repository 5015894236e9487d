#pragma once

namespace cli {

/// Tells whether the terminal can print lines and nothing else: TERM is dumb.
bool is_dumb_terminal();

/// Switches colors off where the user or the terminal wants none: NO_COLOR is set and not empty
/// (no-color.org), or TERM is dumb. Elsewhere PCL colors what goes to a terminal that it knows.
void choose_colors();

}  // namespace cli
