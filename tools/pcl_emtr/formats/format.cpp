#include "formats/format.h"

#include "formats/beginning.h"
#include "read/cloud_path.h"
#include "read/module_reader.h"
#include "read/npy_reader.h"
#include "read/obj_reader.h"
#include "read/off_reader.h"
#include "read/pcl_readers.h"
#include "read/stl_reader.h"
#include "read/text_reader.h"
#include "text/words.h"

namespace cli {
namespace {

std::string extensions(bool written_only) {
  std::vector<std::string> names;
  for (const Format& format : formats())
    if (format.written || !written_only) names.emplace_back(format.extension);
  return joined(names, " or ");
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> table = {
      {".pcd", "PCL's clouds: ascii, binary, compressed", begins_pcd, read_pcd, true},
      {".ply", "clouds and meshes: ascii, binary", begins_ply, read_ply, true, true},
      {".obj", "clouds and meshes", begins_obj, read_obj, true, true},
      {".npy", "an array (N, 3) of numpy, float32 or float64", begins_npy, read_npy},
      {".las", "LiDAR points", begins_las, read_las},
      {".laz", "the same, compressed", begins_las, read_las},
      {".e57", "scans", begins_e57, read_e57},
      {".off", "meshes: ascii", begins_off, read_off},
      {".stl", "meshes: ascii, binary", begins_stl, read_stl},
      {".xyz", "text: a line x y z a point", begins_text, read_text},
      {".txt", "the same", begins_text, read_text, false, false, true},
      {".asc", "the same", begins_text, read_text},
      {".csv", "the same with commas or semicolons", begins_text, read_text},
      {".pts", "the same behind the number of points", begins_text, read_text},
  };
  return table;
}

const Format* find_format(const std::string& name) {
  const std::string extension = lower_case(name.substr(0, 1) == "." ? name : "." + name);
  for (const Format& format : formats())
    if (extension == format.extension) return &format;
  return nullptr;
}

const Format* format_of(const std::string& path) { return find_format(extension_of(path)); }

const Format* guess_format(std::string_view beginning) {
  for (const Format& format : formats())
    if (format.begins(beginning)) return &format;
  return nullptr;
}

std::string read_extensions() { return extensions(false); }

std::string written_extensions() { return extensions(true); }

}  // namespace cli
