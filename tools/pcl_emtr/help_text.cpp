#include "help_text.h"

namespace cli {

const char kDescription[] =
    "Registers two partially overlapping point clouds, globally: no initial guess is needed, and\n"
    "no length has to be set, whatever the unit. Gives the rigid transformation T that maps\n"
    "SOURCE into TARGET, q = R p + t (EMTR-SSC, evolutionary multitasking with solution space\n"
    "cutting).";

const char kFooter[] = R"(
Examples:
  pcl_emtr scan1.pcd scan2.pcd -o T.txt          the matrix, read by numpy.loadtxt("T.txt")
  pcl_emtr scan1.ply scan2.obj > T.txt           the same; all messages go to standard error
  pcl_emtr a.pcd b.pcd -o T.txt --aligned moved.pcd --report run.json
  pcl_emtr a.pcd b.pcd --seed 7 --threads 4      same seed, same result, for any --threads
  pcl_emtr a.pcd b.pcd --preset paper --dense-points 8000 --iterations 200

Notes:
  Clouds are PCD (ascii, binary, compressed), PLY or OBJ by extension, in any letter case;
  x, y and z must be float or double. Points with a NaN or an infinity are dropped and counted.
  Of a mesh only the vertices are read, without faces and textures.
  Presets: "default", whose values are the defaults above; "fast" takes less time; "thorough"
  always searches twice; "paper" is the method as published by Wu et al., IEEE TETCI, 2023. A
  setting given beside a preset changes that one setting.
  The confidence is the probability held that T is right: within 5 degrees, and within 0.06 of
  the larger cloud's radius where the source ends up. Preset "paper" has none.
  Outputs are written whole or not at all. Ctrl-C, SIGTERM and --time-limit stop the search and
  give the best pose so far, as not registered; a second Ctrl-C ends the program.

Exit codes:
  0  registered
  1  usage: an unknown option, a value out of range, options that contradict each other
  2  input or output: a file that is missing, damaged, of unknown format or cannot be written,
     or a cloud that cannot be registered (fewer than 10 finite points, or all on a line)
  3  not registered: T is written all the same, but is doubtful; the reason is told: too little
     overlap, another pose that fits as well, too few matches, surfaces that slide along
     themselves, or the time limit
  130, 143  stopped by Ctrl-C, by SIGTERM: the best pose so far is written, if any was known
)";

}  // namespace cli
