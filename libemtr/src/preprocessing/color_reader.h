#pragma once

#include <emtr/emtr.h>

#include <cstddef>
#include <optional>
#include <string>

namespace emtr {

/// Which of the two a cloud has beside its points. Those of two clouds can be compared only where
/// they are of one kind.
enum class ColorKind { None, Colors, Intensities };

/// Reads what a point looks like, as three channels. Of a color: its mean, and two differences that
/// are 0 where it is gray. Of an intensity: the intensity and two zeros.
class ColorReader {
 public:
  /// Returns a reader of the cloud's colors, or of its intensities where it has no colors; none
  /// where it has neither. Throws Error, naming the cloud, on a stride that is too short.
  static std::optional<ColorReader> of(const emtr_cloud& cloud, const std::string& name);

  ColorKind kind() const { return kind_; }

  /// Reads the channels of one point; writes NaN where it has no color: one that is not finite or,
  /// of intensities, below 0.
  void read(std::size_t index, float channels[3]) const;

 private:
  ColorReader(ColorKind kind, const float* first, std::size_t stride)
      : kind_(kind), first_(reinterpret_cast<const char*>(first)), stride_(stride) {}

  ColorKind kind_;
  const char* first_;
  std::size_t stride_;
};

}  // namespace emtr
