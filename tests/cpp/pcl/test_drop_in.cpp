// Tests a program written for ICP in which the build changed only the include and the type.
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "support.h"

namespace {

void writePcd(const std::string& path, const pcl::PointCloud<pcl::PointXYZ>& cloud,
              const Eigen::Matrix4f& move) {
  std::ofstream file(path);
  file.precision(9);
  file << "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << cloud.size()
       << "\nHEIGHT 1\nPOINTS " << cloud.size() << "\nDATA ascii\n";
  for (const auto& p : cloud) {
    const Eigen::Vector4f q = move * Eigen::Vector4f(p.x, p.y, p.z, 1.0f);
    file << q.x() << ' ' << q.y() << ' ' << q.z() << '\n';
  }
  ASSERT_TRUE(file.good()) << path;
}

struct Answer {
  bool converged = false;
  double score = -1.0;
  Eigen::Matrix4f transformation;
};

Answer run(const std::string& program, const std::string& source, const std::string& target) {
  Answer answer;
  FILE* pipe = popen(('"' + program + "\" \"" + source + "\" \"" + target + '"').c_str(), "r");
  std::string text;
  std::array<char, 256> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe)) text += buffer.data();
  EXPECT_EQ(pclose(pipe), 0) << text;
  std::istringstream words(text);
  words >> answer.converged >> answer.score;
  for (int i = 0; i < 16; ++i) words >> answer.transformation(i / 4, i % 4);
  EXPECT_FALSE(words.fail()) << text;
  return answer;
}

TEST(DropIn, TheSameProgramWithAnotherIncludeAndType) {
  const std::string far_source = testing::TempDir() + "emtr_drop_in_far.pcd";
  const std::string near_source = testing::TempDir() + "emtr_drop_in_near.pcd";
  const std::string target = testing::TempDir() + "emtr_drop_in_target.pcd";
  const Eigen::Matrix4f pose = sharedPair().pose().cast<float>();
  writePcd(far_source, *sharedPair().source(), Eigen::Matrix4f::Identity());
  writePcd(near_source, *sharedPair().source(), pose);  // where ICP has nothing left to find
  writePcd(target, *sharedPair().target(), Eigen::Matrix4f::Identity());

  const Answer icp = run(EMTR_ICP_PROGRAM, near_source, target);
  EXPECT_TRUE(icp.converged);
  const Answer ours = run(EMTR_DROP_IN_PROGRAM, far_source, target);
  EXPECT_TRUE(ours.converged);
  EXPECT_LT(sharedPair().error(ours.transformation), kRight);
  EXPECT_GT(ours.score, 0.0);
  EXPECT_LT(ours.score, 0.1);  // squared radii, with the points that have no correspondence
}

}  // namespace
