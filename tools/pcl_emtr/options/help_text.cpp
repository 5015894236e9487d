#include "options/help_text.h"

namespace cli {

const char kShortHelp[] = R"(Usage: pcl_emtr [OPTIONS] source target

Registers two partially overlapping point clouds without an initial guess.
Prints T, which maps source into target: q = R p + t.

  source              the cloud to move (.pcd, .ply, .obj)
  target              the cloud that stays
  -o, --output FILE   write T to this text file instead of standard output
  --aligned FILE      write the source moved by T as .pcd or .ply
  --report FILE       write settings, timings, quality, verdict and T as JSON
  --residuals         add each point's distance to the target to both files
  --preset NAME       default, fast, thorough, or paper (the published method)
  --guess FILE        try this pose too: a text file of a 4x4 matrix
  --seed N            seed of all random numbers; same seed, same result
  --threads N         number of threads (default: all); same result
  --time-limit X      stop after X seconds with the best pose so far
  -q, --quiet         print errors and warnings only
  --help-all          every option and setting, examples, notes
  --version           versions of pcl_emtr, PCL and Eigen

Example: pcl_emtr scan1.pcd scan2.pcd -o T.txt --aligned moved.pcd
Exit codes: 0 registered, 1 wrong usage, 2 a file cannot be read or written,
3 not registered (T is doubtful), 130 or 143 stopped by a signal.
)";

const char kDescription[] =
    "Registers two partially overlapping point clouds. It needs no initial guess and no length in\n"
    "the clouds' unit. The result is the rigid transformation T that maps SOURCE into TARGET,\n"
    "q = R p + t. The method is EMTR-SSC: evolutionary multitasking with solution space cutting.\n";

const char kFooter[] = R"(
Examples:
  pcl_emtr scan1.pcd scan2.pcd -o T.txt          the matrix, read by numpy.loadtxt("T.txt")
  pcl_emtr scan1.ply scan2.obj > T.txt           the same; all messages go to standard error
  pcl_emtr a.pcd b.pcd -o T.txt --aligned moved.pcd --report run.json
  pcl_emtr a.pcd b.pcd --seed 7 --threads 4      same seed, same result, for any --threads
  pcl_emtr a.pcd b.pcd --preset paper --dense-points 8000 --iterations 200

Notes:
  Clouds are PCD (ascii, binary, compressed), PLY or OBJ by extension, in any letter case. Their
  x, y and z must be float or double. Points with a NaN or an infinity are dropped and counted.
  A mesh is read without its faces and textures.
  Presets: "default" has the default values above, "fast" takes less time, "thorough" always adds
  the fallback search, and "paper" is the method as published by Wu et al., IEEE TETCI, 2023. A
  setting given together with a preset changes that one setting.
  The confidence is the estimated probability that T is right: within 5 degrees, and with the
  source within 0.06 of the larger cloud's radius. Preset "paper" has none.
  Outputs are written whole or not at all. Ctrl-C, SIGTERM and --time-limit stop the search: it
  gives the best pose so far, as not registered. A second Ctrl-C ends the program at once.

Exit codes:
  0  registered
  1  usage: an unknown option, a value out of range, options that contradict each other
  2  input or output: a file that is missing, damaged, of unknown format or cannot be written,
     or a cloud that cannot be registered (fewer than 10 finite points, or all on one line)
  3  not registered: T is written, but is doubtful. A message tells the reason: too little
     overlap, another pose that fits as well, too few correspondences, surfaces that leave a
     direction unconstrained, or the time limit
  130, 143  stopped by Ctrl-C or by SIGTERM: the best pose so far is written, if any was known
)";

}  // namespace cli
