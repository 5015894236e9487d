// Finds the bins of directions on the faces of a cube. Included by each instruction set's file.

#include "kernels/lanes.h"
#include "kernels/search_kernels.h"

namespace emtr::EMTR_KERNEL {
namespace {

EMTR_INLINE Ints<kWide> along_face(const Sixteen& tangent, float half_side) {
  const Sixteen place =
      tangent * (broadcast<kWide>(1.2f) - (broadcast<kWide>(0.2f) * tangent) * tangent);
  return truncated((place + broadcast<kWide>(1.0f)) * broadcast<kWide>(half_side));
}

void direction_bins(const PointsView& d, float half_side, const BinsOut& out) {
  for (std::size_t i = 0; i < d.size; i += kWide) {
    const Sixteen x = load<kWide>(d.x + i), y = load<kWide>(d.y + i), z = load<kWide>(d.z + i);
    const Sixteen ax = magnitude(x), ay = magnitude(y), az = magnitude(z);
    const Ints<kWide> on_z = (az >= ax) & (az >= ay), on_x = ax >= ay;  // on_z comes first
    const auto choose = [&](const Sixteen& of_z, const Sixteen& of_x, const Sixteen& of_y) {
      return blend(on_z, of_z, blend(on_x, of_x, of_y));
    };
    const Ints<kWide> behind = ~(broadcast<kWide>(0.0f) < choose(z, x, y));
    const Ints<kWide> face = ~on_z & ((on_x & broadcast<kWide>(std::int32_t{2})) |
                                      (~on_x & broadcast<kWide>(std::int32_t{4})));
    const Sixteen inverse =
        broadcast<kWide>(1.0f) / maximum(choose(az, ax, ay), broadcast<kWide>(1e-20f));
    store<kWide, Ints>(out.face + i, face | (behind & broadcast<kWide>(std::int32_t{1})));
    store<kWide, Ints>(out.column + i, along_face(choose(x, y, z) * inverse, half_side));
    store<kWide, Ints>(out.row + i, along_face(choose(y, z, x) * inverse, half_side));
  }
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
