#include "batch/register_pair.h"

#include <exception>
#include <filesystem>
#include <new>

#include "batch/record.h"
#include "failure.h"
#include "interrupt.h"
#include "registration.h"

namespace cli {
namespace {

int ask_to_stop(const emtr_progress* /*progress*/, void* /*user*/) {
  return Interrupt::requested() ? 1 : 0;
}

ReadCloudPtr cloud_of(const std::string& path, const Pair& pair, const Options& options,
                      CloudCache& cache, StatusLine& status) {
  const std::size_t mesh_points = pair.settings->mesh_points;
  const std::string place = std::filesystem::absolute(path).lexically_normal().string();
  return cache.get(std::to_string(mesh_points) + " " + place, [&] {
    auto cloud = read_cloud(path, mesh_points, options);
    if (!cloud->note.empty()) status.warning("'" + path + "': " + cloud->note);
    return cloud;
  });
}

void take_viewpoint(const ReadCloud& cloud, std::int32_t& known, double (&position)[3]) {
  if (known || !cloud.sensor_known) return;
  Eigen::Vector3d::Map(position) = cloud.sensor_origin;
  known = 1;
}

std::optional<Json> record_of(const Pair& pair, const Options& options, CloudCache& cache,
                              StatusLine& status) {
  const ReadCloudPtr source = cloud_of(pair.source, pair, options, cache, status);
  const ReadCloudPtr target = cloud_of(pair.target, pair, options, cache, status);
  emtr_settings settings = pair.settings->settings;
  if (options.viewpoints_from_files) {
    take_viewpoint(*source, settings.has_viewpoint_source, settings.viewpoint_source);
    take_viewpoint(*target, settings.has_viewpoint_target, settings.viewpoint_target);
  }
  emtr_result* raw = nullptr;
  const emtr_status done =
      emtr_register_preprocessed(source->preprocessed.get(), target->preprocessed.get(), &settings,
                                 ask_to_stop, nullptr, &raw);
  if (done != EMTR_OK) {
    const std::string message = emtr_error_message();
    return error_record(pair, message.empty() ? emtr_status_text(done) : message);
  }
  const Result result(raw);
  if (result->reason == EMTR_REASON_INTERRUPTED) return std::nullopt;
  return result_record(pair, settings, *result);
}

}  // namespace

std::optional<Json> register_pair(const Pair& pair, const Options& options, CloudCache& cache,
                                  StatusLine& status) {
  std::string fault;
  try {
    std::optional<Json> record = record_of(pair, options, cache, status);
    if (!record || (*record)["status"] != "error") return record;
    fault = (*record)["error"].get<std::string>();
  } catch (const std::bad_alloc&) {
    fault = "not enough memory";
  } catch (const std::exception& error) {  // a Failure that names the file, or of the file system
    fault = error.what();
  }
  status.warning("pair " + std::to_string(pair.index) +
                 (pair.name.empty() ? "" : " (" + pair.name + ")") + ": " + fault);
  return error_record(pair, fault);
}

}  // namespace cli
