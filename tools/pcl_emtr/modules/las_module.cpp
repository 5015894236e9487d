// The module for LAS and LAZ files, by LASzip.
#include <laszip/laszip_api.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "modules/module.h"

namespace {

/// Closes and frees a reader of LASzip.
struct Reader {
  laszip_POINTER laszip = nullptr;
  bool open = false;

  ~Reader() {
    if (open) laszip_close_reader(laszip);
    if (laszip) laszip_destroy(laszip);
  }

  std::string error() const {
    laszip_CHAR* text = nullptr;
    return laszip_get_error(laszip, &text) == 0 && text ? text : "for a reason that is not known";
  }
};

/// Returns what is wrong with the file, or "".
std::string read(const char* place, emtr_module_sink* sink) {
  Reader reader;
  laszip_BOOL compressed = 0;
  laszip_header* header = nullptr;
  laszip_point* point = nullptr;
  if (laszip_create(&reader.laszip) != 0) return "LASzip cannot be used";
  if (laszip_open_reader(reader.laszip, place, &compressed) != 0)
    return "cannot be read: " + reader.error();
  reader.open = true;
  if (laszip_get_header_pointer(reader.laszip, &header) != 0 ||
      laszip_get_point_pointer(reader.laszip, &point) != 0)
    return "cannot be read: " + reader.error();
  // LAS 1.4 has a second count, for more points than the first one can tell.
  const auto count = static_cast<laszip_I64>(header->number_of_point_records
                                                 ? header->number_of_point_records
                                                 : header->extended_number_of_point_records);
  if (count <= 0) return "holds no points";
  const auto bytes = static_cast<laszip_I64>(std::filesystem::file_size(place));
  if (!compressed && count > bytes / std::max<laszip_I64>(header->point_data_record_length, 1))
    return "truncated: its header declares " + std::to_string(count) + " points, it has " +
           std::to_string(bytes) + " bytes";

  const bool colored = header->point_data_format == 2 || header->point_data_format == 3 ||
                       header->point_data_format == 5 || header->point_data_format == 7 ||
                       header->point_data_format == 8 || header->point_data_format == 10;
  const char* const names[] = {"intensity", "classification", "gps_time", "red", "green", "blue"};
  // A file may declare any number of points; few compressed ones take less than a byte.
  if (sink->begin(sink, names, colored ? 6 : 3, static_cast<uint64_t>(std::min(count, bytes))))
    return "";
  for (laszip_I64 i = 0; i < count; ++i) {
    double values[9] = {};
    if (laszip_read_point(reader.laszip) != 0 || laszip_get_coordinates(reader.laszip, values) != 0)
      return "truncated or damaged behind " + std::to_string(i) + " of " + std::to_string(count) +
             " points: " + reader.error();
    values[3] = point->intensity;
    values[4] =
        header->point_data_format >= 6 ? point->extended_classification : point->classification;
    values[5] = point->gps_time;
    for (int k = 0; k < 3; ++k) values[6 + k] = point->rgb[k];
    if (sink->add(sink, values)) return "";
  }
  return "";
}

}  // namespace

extern "C" int emtr_module_read_1(const char* place, emtr_module_sink* sink, char* error,
                                  size_t size) {
  std::string what;
  try {
    what = read(place, sink);
  } catch (const std::exception& failure) {
    what = failure.what();
  }
  std::snprintf(error, size, "%s", what.c_str());
  return what.empty() ? 0 : 1;
}
