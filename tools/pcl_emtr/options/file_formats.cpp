#include "options/file_formats.h"

#include "failure.h"
#include "text/numbers.h"

namespace cli {
namespace {

constexpr std::size_t kMeshPoints = 100000, kMostMeshPoints = 100000000;

}  // namespace

void check_formats(const Options& options) {
  if (!options.input_format.empty() && !find_format(options.input_format))
    throw UsageFailure("--input-format: '" + options.input_format + "' is not " +
                       read_extensions());
  if (options.aligned_format.empty()) return;
  const Format* format = find_format(options.aligned_format);
  if (!format || !format->written)
    throw UsageFailure("--aligned-format: '" + options.aligned_format + "' is not " +
                       written_extensions());
  if (options.aligned.empty()) throw UsageFailure("--aligned-format: expected --aligned too");
}

std::size_t mesh_points(const std::string& text, const Options& options) {
  const char* of_vertices = options.fields.normals                  ? "--use-normals"
                            : !options.fields.features.empty()      ? "--use-features"
                            : !options.correspondences.path.empty() ? "--correspondences"
                                                                    : nullptr;
  if (text.empty()) return of_vertices ? 0 : kMeshPoints;
  const auto count = parse_unsigned(text);
  if (!count || *count > kMostMeshPoints)
    throw UsageFailure("--mesh-points: '" + text + "' is not a whole number from 0 to " +
                       std::to_string(kMostMeshPoints));
  if (*count > 0 && of_vertices)
    throw UsageFailure(std::string("--mesh-points ") + text + " and " + of_vertices +
                       " contradict each other, which belongs to the vertices: --mesh-points 0");
  return *count;
}

const Format* aligned_format(const Options& options, const CloudFile& source) {
  if (options.aligned.empty()) return nullptr;
  if (!options.aligned_format.empty()) return find_format(options.aligned_format);
  if (const Format* format = format_of(options.aligned)) return format;
  return source.format->written ? source.format : find_format(".pcd");
}

}  // namespace cli
