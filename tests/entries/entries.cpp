// entries SOURCE.pcd TARGET.pcd THREADS SEED PRESET [normals | features | priors |
// FILE]: by the class,
// twice with one object, and by the C API, each on a line of its own in hexadecimal: 16 numbers of
// the transformation, 4 of the agreement, and the residuals of the source. With the normals or the
// field fpfh of the files, or a file of correspondences; with priors those that
// priors_of() knows.
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

// The same in test_entries.py, and true of the pair that is made there.
constexpr double kAxis[3] = {1, 1.1, 1}, kTilt = 8, kLeast = -170, kMost = 200, kLargest = 170;
constexpr double kLow[3] = {-9, -9, -9}, kHigh[3] = {9, 9, 9}, kDegrees = 40, kDistance = 3;
constexpr double kGuess[16] = {0, 0, 1, -5.5, 1, 0, 0, -4.5, 0, 1, 0, -5, 0, 0, 0, 1};

void priors_of(emtr_settings& settings) {
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

/// What is handed in; what is not is empty.
struct Handed {
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
  void hand_in(Registration& registration) const {
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

  void hand_in(int side, emtr_cloud& cloud) const {
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

void print(const double* T, const emtr_result& r, const std::vector<double>& residuals) {
  for (int i = 0; i < 16; ++i) std::printf("%a ", T[i]);
  std::printf("%a %a %a %a", r.overlap_source, r.overlap_target, r.inlier_rmse,
              r.inlier_rmse_plane);
  for (const double residual : residuals) std::printf(" %a", residual);
  std::printf("\n");
}

bool by_class(const Cloud::Ptr& source, const Cloud::Ptr& target, const Chosen& chosen,
              const Handed& handed) {
  pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ, double> registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  if (!registration.setPreset(chosen.preset)) return false;
  registration.setNumberOfThreads(static_cast<unsigned>(chosen.threads));
  registration.setSeed(chosen.seed);
  Eigen::Matrix4d guess = Eigen::Matrix4d::Identity();
  if (chosen.priors) {
    using Eigen::Vector3d;
    registration.setRotationAxis(Vector3d::Map(kAxis), kTilt, kLeast, kMost);
    registration.setMaximumRotation(kLargest);
    registration.setTranslationBounds(Vector3d::Map(kLow), Vector3d::Map(kHigh));
    registration.setGuessRadius(kDegrees, kDistance);
    guess = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(kGuess);
  }
  handed.hand_in(registration);
  for (int twice = 0; twice < 2; ++twice) {
    Cloud aligned;
    registration.align(aligned, guess);
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> T = registration.getFinalTransformation();
    print(T.data(), *registration.getResult(), registration.getSourceResiduals());
  }
  return true;
}

int by_c(const Cloud& source, const Cloud& target, const Chosen& chosen, const Handed& handed) {
  emtr_settings settings;
  emtr_result* result = nullptr;
  if (emtr_settings_init(&settings, sizeof settings, chosen.preset) != EMTR_OK) return 1;
  settings.threads = chosen.threads;
  settings.seed = chosen.seed;
  if (chosen.priors) priors_of(settings);
  emtr_cloud from{&source[0].x, source.size(), sizeof source[0], EMTR_FLOAT32};
  emtr_cloud to{&target[0].x, target.size(), sizeof target[0], EMTR_FLOAT32};
  handed.hand_in(0, from);
  handed.hand_in(1, to);
  if (!handed.rows.empty()) settings.correspondences = handed.rows.data();
  settings.correspondence_count = handed.rows.size() / 2;
  if (emtr_register(&from, &to, &settings, nullptr, nullptr, &result) != EMTR_OK) {
    std::fprintf(stderr, "%s\n", emtr_error_message());
    return 1;
  }
  std::vector<double> residuals(source.size());
  if (emtr_residuals(&from, &to, result->transformation, chosen.threads, residuals.data(),
                     nullptr) != EMTR_OK)
    return 1;
  print(result->transformation, *result, residuals);
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
  Handed handed;
  if (argc == 7 && !chosen.priors && !handed.read(argv[6], argv + 1)) return 2;
  return by_class(source, target, chosen, handed) ? by_c(*source, *target, chosen, handed) : 2;
}
