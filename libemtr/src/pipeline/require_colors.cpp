#include "pipeline/require_colors.h"

#include "settings/choices.h"
#include "util/error.h"

namespace emtr {

void require_colors(const Settings& settings, const PreprocessedCloud& source,
                    const PreprocessedCloud& target) {
  if (!(settings.use_colors == When::Always)) return;
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw Error(EMTR_ERROR_ARGUMENT, message);
  };
  require(source.color_kind != ColorKind::None,
          "source cloud: has neither colors nor intensities, expected some for use_colors on");
  require(target.color_kind != ColorKind::None,
          "target cloud: has neither colors nor intensities, expected some for use_colors on");
  require(source.color_kind == target.color_kind,
          "clouds: one has colors and the other intensities, expected the same of both for "
          "use_colors on");
}

}  // namespace emtr
