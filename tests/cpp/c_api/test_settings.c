/* Tests the version, the texts, the presets, and the settings by name. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"

static void texts(void) {
  static const char* const names[] = {"registered",  "low_overlap", "ambiguous",  "few_matches",
                                      "interrupted", "degenerate",  "time_limit", "mirrored",
                                      "scale",       "free_scale"};
  static const char* const stages[] = {
      "normalization", "scale_search", "downsampling",    "features",   "matching", "seeds",
      "evolution",     "candidates",   "fallback_search", "refinement", "verdict"};
  char version[32];
  int i;
  snprintf(version, sizeof version, "%d.%d.%d", EMTR_VERSION_MAJOR, EMTR_VERSION_MINOR,
           EMTR_VERSION_PATCH);
  CHECK(strcmp(emtr_version(), version) == 0);
  for (i = EMTR_OK; i <= EMTR_ERROR_INTERRUPTED; ++i)
    CHECK(emtr_status_text((emtr_status)i) && *emtr_status_text((emtr_status)i));
  for (i = EMTR_REASON_REGISTERED; i <= EMTR_REASON_FREE_SCALE; ++i) {
    CHECK(strcmp(emtr_reason_name((emtr_reason)i), names[i]) == 0);
    CHECK(emtr_reason_text((emtr_reason)i) && *emtr_reason_text((emtr_reason)i));
  }
  for (i = 0; i < 11; ++i) CHECK(strcmp(emtr_stage_name((size_t)i), stages[i]) == 0);
  CHECK(emtr_stage_name(11) == NULL);
  CHECK(emtr_status_text((emtr_status)99) != NULL);
  CHECK(emtr_reason_text((emtr_reason)99) != NULL);
  CHECK(strcmp(emtr_reason_name((emtr_reason)99), "unknown") == 0);
  CHECK(*emtr_error_message() == '\0'); /* nothing has failed yet */
}

static void presets(void) {
  emtr_settings by_name, by_null;
  size_t i;
  CHECK(emtr_preset_name(0) && strcmp(emtr_preset_name(0), "default") == 0);
  for (i = 0; emtr_preset_name(i); ++i)
    CHECK_OK(emtr_settings_init(&by_name, sizeof by_name, emtr_preset_name(i)));
  CHECK(emtr_preset_name(i + 1) == NULL);

  /* the method as published has no seeds before the swarm and nothing after it */
  CHECK_OK(emtr_settings_init(&by_name, sizeof by_name, "paper"));
  CHECK(by_name.population == 50 && by_name.iterations == 100);
  CHECK(by_name.features == EMTR_FEATURES_PCL && by_name.fallback_search == EMTR_OFF);
  CHECK(!by_name.seeds && !by_name.candidates && !by_name.refine);

  CHECK_OK(emtr_settings_init(&by_name, sizeof by_name, "default"));
  CHECK_OK(emtr_settings_init(&by_null, sizeof by_null, NULL));
  CHECK(by_name.size == sizeof(emtr_settings) && !by_name.has_guess);
  CHECK(by_name.features == EMTR_FEATURES_SIMD && by_name.neighbors == EMTR_NEIGHBORS_GRID);
  CHECK(by_name.fallback_search == EMTR_AUTO);
  CHECK(!by_name.has_viewpoint_source && !by_name.has_viewpoint_target);
  for (i = 0; i < emtr_setting_count(); ++i) {
    emtr_setting_info info;
    double a = 0, b = 1;
    CHECK_OK(emtr_setting_describe(i, &info, sizeof info));
    CHECK_OK(emtr_setting_get(&by_name, info.name, &a));
    CHECK_OK(emtr_setting_get(&by_null, info.name, &b));
    CHECK(a == b && a == info.value);
  }
  CHECK_ERROR(emtr_settings_init(&by_name, sizeof by_name, "papier"), EMTR_ERROR_SETTING, "papier");
  CHECK_ERROR(emtr_settings_init(&by_name, 4, "paper"), EMTR_ERROR_ARGUMENT, "size");
  CHECK_ERROR(emtr_settings_init(NULL, sizeof by_name, "paper"), EMTR_ERROR_ARGUMENT, "null");
}

/* Checks that a refused value does not change the setting. */
static void refuses(const char* name, double value) {
  emtr_settings settings;
  double before = 0, after = 1;
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, NULL));
  CHECK_OK(emtr_setting_get(&settings, name, &before));
  CHECK_ERROR(emtr_setting_set(&settings, name, value), EMTR_ERROR_SETTING, name);
  CHECK_OK(emtr_setting_get(&settings, name, &after));
  CHECK(before == after);
}

static void each_setting(void) {
  size_t i;
  CHECK(emtr_setting_count() > 30);
  for (i = 0; i < emtr_setting_count(); ++i) {
    emtr_setting_info info;
    emtr_settings settings;
    double got = 0;
    CHECK_OK(emtr_settings_init(&settings, sizeof settings, NULL));
    CHECK_OK(emtr_setting_describe(i, &info, sizeof info));
    CHECK(*info.name && *info.text && info.unit && info.part && info.choices);
    CHECK(info.minimum <= info.value && info.value <= info.maximum);
    CHECK((info.type == EMTR_SETTING_CHOICE) == (*info.choices != '\0'));

    CHECK_OK(emtr_setting_set(&settings, info.name, info.minimum));
    CHECK_OK(emtr_setting_get(&settings, info.name, &got));
    CHECK(got == info.minimum);
    CHECK_OK(emtr_setting_set(&settings, info.name, info.maximum));
    CHECK_OK(emtr_setting_get(&settings, info.name, &got));
    CHECK(got == info.maximum);
    refuses(info.name, info.minimum - 1);
    refuses(info.name, info.maximum * 2 + 1);
    refuses(info.name, (double)NAN);
    if (info.type != EMTR_SETTING_REAL) refuses(info.name, info.minimum + 0.5);
  }
}

static void wrong_names(void) {
  emtr_settings settings;
  emtr_setting_info info;
  double value = 7;
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, NULL));
  CHECK_OK(emtr_setting_set(&settings, "population", 30));
  CHECK(settings.population == 30);
  CHECK_ERROR(emtr_setting_set(&settings, "polulation", 30), EMTR_ERROR_SETTING, "polulation");
  CHECK_ERROR(emtr_setting_get(&settings, "guess", &value), EMTR_ERROR_SETTING, "guess");
  CHECK(value == 7);
  CHECK(emtr_setting_set(NULL, "population", 30) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_setting_set(&settings, NULL, 30) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_setting_get(&settings, "population", NULL) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_setting_describe(emtr_setting_count(), &info, sizeof info) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_setting_describe(0, NULL, sizeof info) == EMTR_ERROR_ARGUMENT);
}

/* An older header gives an error; a later header gets zeros in its new fields. */
static void sizes(void) {
  struct {
    emtr_setting_info info;
    char later[24];
  } grown;
  size_t i;
  memset(&grown, 7, sizeof grown);
  CHECK_ERROR(emtr_setting_describe(0, &grown.info, sizeof grown.info - 1), EMTR_ERROR_ARGUMENT,
              "size is");
  CHECK(grown.later[0] == 7);
  CHECK_OK(emtr_setting_describe(0, &grown.info, sizeof grown));
  CHECK(strcmp(grown.info.name, "seed") == 0);
  for (i = 0; i < sizeof grown.later; ++i) CHECK(grown.later[i] == 0);
}

int main(void) {
  texts();
  presets();
  each_setting();
  wrong_names();
  sizes();
  return check_result();
}
