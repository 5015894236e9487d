#include "options/help_text.h"

#include "formats/format.h"
#include "text/words.h"

namespace cli {
namespace {

/// Returns the extensions, and where to break the line between them.
std::string formats_text() {
  std::string text;
  for (const Format& format : formats()) text += std::string(format.extension) + " ";
  text = wrapped(text + "(.gz)", 77);
  const std::string indent = "\n  ";
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += indent.size())
    text.replace(at, 1, indent);
  return text;
}

}  // namespace

std::string short_help() {
  return R"(Usage: pcl_emtr [OPTIONS] source target
   or: pcl_emtr [OPTIONS] --batch pairs.csv --out DIR   (many pairs)
   or: pcl_emtr [OPTIONS] --align-all DIR --out DIR     (many scans)

Registers two partially overlapping point clouds without an initial guess.
Prints T, which maps source into target: q = R p + t.
  source, target      the cloud to move and the cloud that stays, or - (stdin):
  )" + formats_text() +
         R"(
  -o, --output FILE   write T to this text file instead of standard output
  --aligned FILE      write the source moved by T as )" +
         written_extensions() + R"(
  --report FILE       write settings, timings, quality, verdict and T as JSON
  --html FILE         write a page to look at: 3-D view, verdict, what to try
  --preset NAME       default, fast, thorough, or paper (the published method)
  --guess FILE        try this pose too: a text file of a 4x4 matrix
  --seed N            seed of all random numbers; same seed, same result
  --threads N         number of threads (default: all); same result
  --time-limit X      stop after X seconds with the best pose so far
  -q, --quiet         print errors and warnings only
  --help-all          every option and setting, examples, notes

Example: pcl_emtr scan1.pcd scan2.pcd -o T.txt --aligned moved.pcd
Exit codes: 0 registered, 1 wrong usage, 2 a file cannot be read or written,
3 not registered (T is doubtful), 130 or 143 stopped by a signal.
)";
}

const char kDescription[] =
    "Registers two partially overlapping point clouds. It needs no initial guess and no length in\n"
    "the clouds' unit. The result is the rigid transformation T that maps SOURCE into TARGET,\n"
    "q = R p + t. The method is EMTR-SSC: evolutionary multitasking with solution space cutting.\n";

std::string help_footer() {
  std::string list;
  for (const Format& format : formats())
    list += std::string("  ") + format.extension + "  " + format.meaning + "\n";
  return R"(
Examples:
  pcl_emtr scan1.pcd scan2.pcd -o T.txt          the matrix, read by numpy.loadtxt("T.txt")
  pcl_emtr scan1.ply scan2.obj > T.txt           the same; all messages go to standard error
  pcl_emtr a.pcd b.pcd -o T.txt --aligned moved.pcd --report run.json
  pcl_emtr scan.pts model.stl -o T.txt --aligned moved.ply --mesh-points 50000
  zcat a.pcd.gz | pcl_emtr - b.pcd --aligned - -o T.txt | ...   streams
  pcl_emtr a.pcd b.pcd --seed 7 --threads 4      same seed, same result, for any --threads
  pcl_emtr a.pcd b.pcd --preset paper --dense-points 8000 --iterations 200
  pcl_emtr --batch pairs.csv --out results       many pairs; again: what is not yet recorded
  pcl_emtr --align-all scans --out aligned       many scans of one thing into one frame

Formats, by extension in any letter case:
)" + list +
         R"(
Notes:
  The x, y and z of PCD and PLY must be float or double. Points with a NaN or an infinity are
  dropped and counted. A file that ends in .gz is unpacked. A pipe or a device is read and written
  as a stream; - is standard input or output. The surface of a mesh is sampled by points.
  Presets: "default" has the default values above, "fast" takes less time, "thorough" always adds
  the fallback search, and "paper" is the method as published by Wu et al., IEEE TETCI, 2023. A
  setting given together with a preset changes that one setting.
  The confidence is the estimated probability that T is right: within 5 degrees, and with the
  source within 0.06 of the larger cloud's radius. Preset "paper" has none.
  Output files are written whole or not at all. NO_COLOR and TERM=dumb switch colors off.
  Ctrl-C, SIGTERM and --time-limit stop the search: it gives the best pose so far, as not
  registered. A second Ctrl-C ends the program at once.
  With --batch a pair with a bad file is recorded with its error, and the others go on. A run that
  was stopped or killed goes on when the same command is given again; nothing is done twice.

Exit codes:
  0  registered
  1  usage: an unknown option, a value out of range, options that contradict each other
  2  input or output: a file that is missing, damaged, of unknown format or cannot be written,
     or a cloud that cannot be registered (fewer than 10 finite points, or all on one line)
  3  not registered: T is written, but is doubtful. A message tells the reason: too little
     overlap, another pose that fits as well, too few correspondences, surfaces that leave a
     direction unconstrained, or the time limit
  130, 143  stopped by Ctrl-C or by SIGTERM: the best pose so far is written, if any was known
  With --batch: 0 when all pairs are registered, 2 when one has an error, else 3
  With --align-all: those of pyemtr-align: 0 when all scans are in one model, 3 when some are left
     out or there are several models, 2 for wrong usage or input
)";
}

}  // namespace cli
