// entries SOURCE.pcd TARGET.pcd THREADS SEED PRESET: by the class, twice with one object, and by
// the C API, each on a line of its own in hexadecimal: 16 numbers of the transformation, 4 of the
// agreement, and the residuals of the source.
#include <emtr/emtr.h>
#include <pcl/io/pcd_io.h>
#include <pcl/registration/emtr_ssc.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Chosen {
  int threads;
  unsigned long seed;
  const char* preset;
};

void print(const double* T, const emtr_result& r, const std::vector<double>& residuals) {
  for (int i = 0; i < 16; ++i) std::printf("%a ", T[i]);
  std::printf("%a %a %a %a", r.overlap_source, r.overlap_target, r.inlier_rmse,
              r.inlier_rmse_plane);
  for (const double residual : residuals) std::printf(" %a", residual);
  std::printf("\n");
}

bool by_class(const Cloud::Ptr& source, const Cloud::Ptr& target, const Chosen& chosen) {
  pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ, double> registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  if (!registration.setPreset(chosen.preset)) return false;
  registration.setNumberOfThreads(static_cast<unsigned>(chosen.threads));
  registration.setSeed(chosen.seed);
  for (int twice = 0; twice < 2; ++twice) {
    Cloud aligned;
    registration.align(aligned);
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> T = registration.getFinalTransformation();
    print(T.data(), *registration.getResult(), registration.getSourceResiduals());
  }
  return true;
}

int by_c(const Cloud& source, const Cloud& target, const Chosen& chosen) {
  emtr_settings settings;
  emtr_result* result = nullptr;
  if (emtr_settings_init(&settings, sizeof settings, chosen.preset) != EMTR_OK) return 1;
  settings.threads = chosen.threads;
  settings.seed = chosen.seed;
  const emtr_cloud from{&source[0].x, source.size(), sizeof source[0], EMTR_FLOAT32};
  const emtr_cloud to{&target[0].x, target.size(), sizeof target[0], EMTR_FLOAT32};
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
  if (argc != 6 || pcl::io::loadPCDFile(argv[1], *source) || pcl::io::loadPCDFile(argv[2], *target))
    return 2;
  const Chosen chosen{std::atoi(argv[3]), std::strtoul(argv[4], nullptr, 10), argv[5]};
  return by_class(source, target, chosen) ? by_c(*source, *target, chosen) : 2;
}
