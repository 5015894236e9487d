// entries SOURCE.pcd TARGET.pcd THREADS SEED PRESET [normals | features | priors | FILE]
//
// Registers by the class, twice with one object, and by the C API. Prints each result as a line
// "result" and lines "name value ...", in hexadecimal. Uses the normals or the field fpfh of the
// files, a file of correspondences, or the priors below.
#include <emtr/emtr.h>
#include <pcl/io/pcd_io.h>
#include <pcl/registration/emtr_ssc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Chosen {
  int threads;
  unsigned long seed;
  const char* preset;
  bool priors;
};

// test_priors.py has the same priors. They hold for its pair but for half a degree of tilt.
constexpr double kAxis[3] = {1, 1.1, 1}, kTilt = 4, kLeast = -170, kMost = 200, kLargest = 170;
constexpr double kLow[3] = {-9, -9, -9}, kHigh[3] = {9, 9, 9}, kDegrees = 40, kDistance = 3;
constexpr double kGuess[16] = {0, 0, 1, -5.5, 1, 0, 0, -4.5, 0, 1, 0, -5, 0, 0, 0, 1};

void set_priors(emtr_settings& settings) {
  settings.has_axis = settings.has_translation_bounds = settings.has_guess = 1;
  std::copy_n(kAxis, 3, settings.axis);
  settings.axis_tilt = kTilt;
  settings.axis_angle_minimum = kLeast;
  settings.axis_angle_maximum = kMost;
  settings.maximum_rotation = kLargest;
  std::copy_n(kLow, 3, settings.translation_minimum);
  std::copy_n(kHigh, 3, settings.translation_maximum);
  std::copy_n(kGuess, 16, settings.guess);
  settings.guess_rotation = kDegrees;
  settings.guess_translation = kDistance;
}

template <class Value>
void print(const char* name, const Value* values, std::size_t n) {
  std::printf("%s", name);
  for (std::size_t i = 0; i < n; ++i) std::printf(" %a", static_cast<double>(values[i]));
  std::printf("\n");
}

void print(const emtr_result& r, const std::vector<double>& residuals) {
  std::printf("result\nreason %s\n", emtr_reason_name(r.reason));
#define SCALAR(field) print(#field, &r.field, 1)
  SCALAR(registered), SCALAR(fitness), SCALAR(inlier_ratio_source), SCALAR(inlier_ratio_target);
  SCALAR(overlap_source), SCALAR(overlap_target), SCALAR(inlier_rmse_plane), SCALAR(leaf_fine);
  SCALAR(inlier_rmse), SCALAR(fitness_gap), SCALAR(points_source), SCALAR(points_target);
  SCALAR(dropped_source), SCALAR(dropped_target), SCALAR(strays_source), SCALAR(strays_target),
      SCALAR(sparse_source), SCALAR(dense_source);
  SCALAR(dense_target), SCALAR(correspondences), SCALAR(tims), SCALAR(tims_pruned);
  SCALAR(normalization_scale), SCALAR(leaf_sparse), SCALAR(leaf_dense), SCALAR(iterations);
  SCALAR(confidence), SCALAR(score), SCALAR(surface_fit), SCALAR(surface_near), SCALAR(violation),
      SCALAR(evidence), SCALAR(scale_factor), SCALAR(score_gap);
  SCALAR(seeds), SCALAR(candidates), SCALAR(used_fallback_search), SCALAR(refined);
  SCALAR(unconstrained_directions);
#undef SCALAR
  print("transformation", r.transformation, 16);
  print("center_source", r.center_source, 3);
  print("center_target", r.center_target, 3);
  print("history_alpha", r.history_alpha, r.iterations);
  print("history_beta", r.history_beta, r.iterations);
  static_assert(sizeof(emtr_alternative) == 20 * sizeof(double), "all doubles, side by side");
  print("alternatives", r.alternative_count ? r.alternatives->transformation : nullptr,
        20 * r.alternative_count);
  print("information", r.information, 36);
  print("hessian_eigenvalues", r.hessian_eigenvalues, 6);
  print("hessian_eigenvectors", r.hessian_eigenvectors, 36);
  const std::uint64_t queries[] = {r.queries_evaluation, r.queries_switch, r.queries_complement};
  print("queries", queries, 3);
  print("residuals", residuals.data(), residuals.size());
  const std::vector<float> single(residuals.begin(), residuals.end());
  print("residuals_single", single.data(), single.size());
}

/// Normals, features or correspondences that the user provides; empty where there are none.
struct UserInput {
  pcl::PointCloud<pcl::Normal>::Ptr normals[2];
  pcl::PointCloud<pcl::FPFHSignature33>::Ptr features[2];
  std::vector<std::int32_t> rows;

  bool read(const std::string& what, const char* const files[2]) {
    if (what != "normals" && what != "features") {
      std::ifstream in(what);
      for (std::int32_t row = 0; in >> row;) rows.push_back(row);
      return !rows.empty();
    }
    for (int i = 0; i < 2; ++i) {
      normals[i] = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
      features[i] = pcl::make_shared<pcl::PointCloud<pcl::FPFHSignature33>>();
      if (what == "normals" ? pcl::io::loadPCDFile(files[i], *normals[i])
                            : pcl::io::loadPCDFile(files[i], *features[i]))
        return false;
      (what == "normals") ? features[i].reset() : normals[i].reset();
    }
    return true;
  }

  template <class Registration>
  void set_user_input(Registration& registration) const {
    if (normals[0]) registration.setSourceNormals(normals[0]);
    if (normals[1]) registration.setTargetNormals(normals[1]);
    if (features[0]) registration.setSourceFeatures(features[0]);
    if (features[1]) registration.setTargetFeatures(features[1]);
    if (rows.empty()) return;
    auto pairs = pcl::make_shared<pcl::Correspondences>();
    for (std::size_t i = 0; i < rows.size(); i += 2)
      pairs->emplace_back(rows[i], rows[i + 1], 0.0f);
    registration.setCorrespondences(pairs);
  }

  void set_user_input(int side, emtr_cloud& cloud) const {
    if (normals[side]) {
      cloud.normals = (*normals[side])[0].normal;
      cloud.normal_stride = sizeof(pcl::Normal);
    }
    if (features[side]) {
      cloud.features = (*features[side])[0].histogram;
      cloud.feature_dimension = 33;
      cloud.feature_stride = sizeof(pcl::FPFHSignature33);
    }
  }
};

bool by_class(const Cloud::Ptr& source, const Cloud::Ptr& target, const Chosen& chosen,
              const UserInput& input) {
  pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ, double> registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  if (!registration.setPreset(chosen.preset)) return false;
  registration.setNumberOfThreads(static_cast<unsigned>(chosen.threads));
  registration.setSeed(chosen.seed);
  input.set_user_input(registration);
  Eigen::Matrix4d guess = Eigen::Matrix4d::Identity();
  if (chosen.priors) {
    using Eigen::Vector3d;
    registration.setRotationAxis(Vector3d::Map(kAxis), kTilt, kLeast, kMost);
    registration.setMaximumRotation(kLargest);
    registration.setTranslationBounds(Vector3d::Map(kLow), Vector3d::Map(kHigh));
    registration.setGuessRadius(kDegrees, kDistance);
    guess = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(kGuess);
  }
  for (int twice = 0; twice < 2; ++twice) {
    Cloud aligned;
    registration.align(aligned, guess);
    if (!registration.getResult()) return false;
    emtr_result result = *registration.getResult();
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> T = registration.getFinalTransformation();
    std::copy_n(T.data(), 16, result.transformation);
    print(result, registration.getSourceResiduals());
  }
  return true;
}

int by_c(const Cloud& source, const Cloud& target, const Chosen& chosen, const UserInput& input) {
  emtr_settings settings;
  emtr_result* result = nullptr;
  if (emtr_settings_init(&settings, sizeof settings, chosen.preset) != EMTR_OK) return 1;
  settings.threads = chosen.threads;
  settings.seed = chosen.seed;
  if (chosen.priors) set_priors(settings);
  emtr_cloud from{&source[0].x, source.size(), sizeof source[0], EMTR_FLOAT32};
  emtr_cloud to{&target[0].x, target.size(), sizeof target[0], EMTR_FLOAT32};
  input.set_user_input(0, from);
  input.set_user_input(1, to);
  if (!input.rows.empty()) settings.correspondences = input.rows.data();
  settings.correspondence_count = input.rows.size() / 2;
  if (emtr_register(&from, &to, &settings, nullptr, nullptr, &result) != EMTR_OK) {
    std::fprintf(stderr, "%s\n", emtr_error_message());
    return 1;
  }
  std::vector<double> residuals(source.size());
  if (emtr_residuals(&from, &to, result->transformation, chosen.threads, residuals.data(),
                     nullptr) != EMTR_OK)
    return 1;
  print(*result, residuals);
  emtr_result_free(result);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  auto source = pcl::make_shared<Cloud>(), target = pcl::make_shared<Cloud>();
  if (argc < 6 || argc > 7 || pcl::io::loadPCDFile(argv[1], *source) ||
      pcl::io::loadPCDFile(argv[2], *target))
    return 2;
  const Chosen chosen{std::atoi(argv[3]), std::strtoul(argv[4], nullptr, 10), argv[5],
                      argc == 7 && std::string(argv[6]) == "priors"};
  UserInput input;
  if (argc == 7 && !chosen.priors && !input.read(argv[6], argv + 1)) return 2;
  return by_class(source, target, chosen, input) ? by_c(*source, *target, chosen, input) : 2;
}
