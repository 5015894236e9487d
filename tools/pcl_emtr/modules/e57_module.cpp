// The module for E57 files, by libE57Format: all scans of a file, each moved by its pose.
#include <E57Format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "modules/module.h"

namespace {

constexpr std::size_t kBlock = 4096;  // points read at once

/// Returns the child of this name as a number, or the value that stands for none.
double number(const e57::StructureNode& node, const std::string& name, double otherwise) {
  if (!node.isDefined(name)) return otherwise;
  const e57::Node child = node.get(name);
  if (child.type() == e57::TypeFloat) return e57::FloatNode(child).value();
  if (child.type() == e57::TypeInteger) return static_cast<double>(e57::IntegerNode(child).value());
  return otherwise;
}

/// Where a scan's own coordinates lie in the file's.
struct Pose {
  double w = 1, x = 0, y = 0, z = 0;
  std::array<double, 3> translation{};

  explicit Pose(const e57::StructureNode& scan) {
    if (!scan.isDefined("pose")) return;
    const e57::StructureNode pose(scan.get("pose"));
    if (pose.isDefined("rotation")) {
      const e57::StructureNode q(pose.get("rotation"));
      w = number(q, "w", 1), x = number(q, "x", 0), y = number(q, "y", 0), z = number(q, "z", 0);
    }
    if (pose.isDefined("translation")) {
      const e57::StructureNode t(pose.get("translation"));
      translation = {number(t, "x", 0), number(t, "y", 0), number(t, "z", 0)};
    }
  }

  void move(double* p) const {
    const double a = p[0], b = p[1], c = p[2];
    p[0] = (1 - 2 * (y * y + z * z)) * a + 2 * (x * y - w * z) * b + 2 * (x * z + w * y) * c;
    p[1] = 2 * (x * y + w * z) * a + (1 - 2 * (x * x + z * z)) * b + 2 * (y * z - w * x) * c;
    p[2] = 2 * (x * z - w * y) * a + 2 * (y * z + w * x) * b + (1 - 2 * (x * x + y * y)) * c;
    for (int i = 0; i < 3; ++i) p[i] += translation[static_cast<std::size_t>(i)];
  }
};

/// The fields of a scan that are read, in blocks.
class Scan {
 public:
  Scan(e57::ImageFile& file, const e57::Node& node)
      : scan_(node), pose_(scan_), points_(scan_.get("points")), prototype_(points_.prototype()) {
    spherical_ = !prototype_.isDefined("cartesianX");
    const char* names[] = {"cartesianX", "cartesianY", "cartesianZ"};
    const char* angles[] = {"sphericalRange", "sphericalAzimuth", "sphericalElevation"};
    for (int i = 0; i < 3; ++i) add(file, spherical_ ? angles[i] : names[i], values_[i]);
    const char* invalid = spherical_ ? "sphericalInvalidState" : "cartesianInvalidState";
    if (prototype_.isDefined(invalid)) add(file, invalid, invalid_);
    if (prototype_.isDefined("intensity")) add(file, "intensity", intensity_);
    const char* colors[] = {"colorRed", "colorGreen", "colorBlue"};
    for (int k = 0; k < 3 && has_color(); ++k) add(file, colors[k], colors_[k]);
  }

  int64_t size() const { return points_.childCount(); }
  bool has_color() const {
    return prototype_.isDefined("colorRed") && prototype_.isDefined("colorGreen") &&
           prototype_.isDefined("colorBlue");
  }

  /// Reads all points; returns false when the sink has no room.
  bool read(emtr_module_sink* sink) {
    e57::CompressedVectorReader reader = points_.reader(buffers_);
    while (const std::size_t count = reader.read())
      for (std::size_t i = 0; i < count; ++i)
        if (!put(i, sink)) return false;
    reader.close();
    return true;
  }

 private:
  void add(e57::ImageFile& file, const std::string& name, std::vector<double>& values) {
    values.resize(kBlock);
    buffers_.emplace_back(file, name, values.data(), kBlock, true, true);
  }

  bool put(std::size_t i, emtr_module_sink* sink) {
    double p[7] = {values_[0][i],
                   values_[1][i],
                   values_[2][i],
                   intensity_.empty() ? NAN : intensity_[i],
                   NAN,
                   NAN,
                   NAN};
    for (int k = 0; k < 3 && has_color(); ++k) p[4 + k] = colors_[k][i];
    if (spherical_) {
      const double range = p[0], azimuth = p[1], elevation = p[2];
      p[0] = range * std::cos(elevation) * std::cos(azimuth);
      p[1] = range * std::cos(elevation) * std::sin(azimuth);
      p[2] = range * std::sin(elevation);
    }
    pose_.move(p);
    if (!invalid_.empty() && invalid_[i] != 0) p[0] = p[1] = p[2] = NAN;
    return sink->add(sink, p) == 0;
  }

  e57::StructureNode scan_;
  Pose pose_;
  e57::CompressedVectorNode points_;
  e57::StructureNode prototype_;
  bool spherical_ = false;
  std::vector<double> values_[3], colors_[3], invalid_, intensity_;
  std::vector<e57::SourceDestBuffer> buffers_;
};

/// Returns what is wrong with the file, or "".
std::string read(const char* place, emtr_module_sink* sink) {
  e57::ImageFile file(place, "r");
  const e57::StructureNode root = file.root();
  if (!root.isDefined("data3D")) return "holds no scans";
  const e57::VectorNode scans(root.get("data3D"));
  const char* const names[] = {"intensity", "red", "green", "blue"};
  bool color = false;
  for (int64_t i = 0; i < scans.childCount(); ++i)
    color = color || Scan(file, scans.get(i)).has_color();
  if (sink->begin(sink, names, color ? 4 : 1, 0)) return "";
  for (int64_t i = 0; i < scans.childCount(); ++i) {
    Scan scan(file, scans.get(i));
    if (scan.size() > 0 && !scan.read(sink)) return "";
  }
  if (scans.childCount() > 1)
    sink->note(sink,
               ("its " + std::to_string(scans.childCount()) + " scans are one cloud").c_str());
  file.close();
  return "";
}

}  // namespace

extern "C" int emtr_module_read_1(const char* place, emtr_module_sink* sink, char* error,
                                  size_t size) {
  std::string what;
  try {
    what = read(place, sink);
  } catch (const e57::E57Exception& failure) {
    what = "cannot be read: " + failure.errorStr();
    if (!failure.context().empty()) what += " (" + failure.context() + ")";
  } catch (const std::exception& failure) {
    what = std::string("cannot be read: ") + failure.what();
  }
  std::snprintf(error, size, "%s", what.c_str());
  return what.empty() ? 0 : 1;
}
