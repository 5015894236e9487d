#include "read/open_cloud.h"

#include "failure.h"
#include "files/streams.h"
#include "files/unpack.h"
#include "formats/format.h"
#include "read/cloud_path.h"

namespace cli {
namespace {

/// Sets the format by the beginning where it is not known; throws when the beginning is of another
/// format, or of none.
void check_beginning(CloudFile& cloud, std::string_view bytes) {
  if (cloud.format && cloud.format->begins(bytes)) return;
  const Format* guess = guess_format(bytes);
  if (cloud.format)
    throw FileFailure(cloud.path,
                      std::string("does not begin like a ") + cloud.format->extension + " file" +
                          (guess ? std::string(", but like a ") + guess->extension + " one" : ""));
  if (!guess)
    throw FileFailure(cloud.path,
                      "its format is not known by its beginning; name it by --input-format");
  cloud.format = guess;
}

}  // namespace

CloudFile open_cloud(const std::string& path, const std::string& format) {
  require_cloud_file(path, format);
  CloudFile cloud;
  cloud.path = path;
  cloud.format = format.empty() ? format_of(path) : find_format(format);
  if (is_stream(path)) {
    cloud.spool = unpack(path, [&](std::string_view bytes) { check_beginning(cloud, bytes); });
  } else if (is_compressed(path)) {
    cloud.spool = unpack(path, [](std::string_view) {});
  }
  cloud.place = cloud.spool ? cloud.spool->place() : path;
  return cloud;
}

}  // namespace cli
