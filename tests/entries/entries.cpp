// entries SOURCE.pcd TARGET.pcd THREADS SEED PRESET [PRIORS]: the transformation by the class,
// twice with one object, and by the C API, each 16 numbers in hexadecimal on a line of its own.
// PRIORS: with those that priors_of() knows.
#include <emtr/emtr.h>
#include <pcl/io/pcd_io.h>
#include <pcl/registration/emtr_ssc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

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

void print(const double* T) {
  for (int i = 0; i < 16; ++i) std::printf("%a%c", T[i], i == 15 ? '\n' : ' ');
}

bool by_class(const Cloud::Ptr& source, const Cloud::Ptr& target, const Chosen& chosen) {
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
  for (int twice = 0; twice < 2; ++twice) {
    Cloud aligned;
    registration.align(aligned, guess);
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> T = registration.getFinalTransformation();
    print(T.data());
  }
  return true;
}

int by_c(const Cloud& source, const Cloud& target, const Chosen& chosen) {
  emtr_settings settings;
  emtr_result* result = nullptr;
  if (emtr_settings_init(&settings, sizeof settings, chosen.preset) != EMTR_OK) return 1;
  settings.threads = chosen.threads;
  settings.seed = chosen.seed;
  if (chosen.priors) priors_of(settings);
  const emtr_cloud from{&source[0].x, source.size(), sizeof source[0], EMTR_FLOAT32};
  const emtr_cloud to{&target[0].x, target.size(), sizeof target[0], EMTR_FLOAT32};
  if (emtr_register(&from, &to, &settings, nullptr, nullptr, &result) != EMTR_OK) {
    std::fprintf(stderr, "%s\n", emtr_error_message());
    return 1;
  }
  print(result->transformation);
  emtr_result_free(result);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  auto source = pcl::make_shared<Cloud>(), target = pcl::make_shared<Cloud>();
  if (argc < 6 || pcl::io::loadPCDFile(argv[1], *source) || pcl::io::loadPCDFile(argv[2], *target))
    return 2;
  const Chosen chosen{std::atoi(argv[3]), std::strtoul(argv[4], nullptr, 10), argv[5], argc > 6};
  return by_class(source, target, chosen) ? by_c(*source, *target, chosen) : 2;
}
