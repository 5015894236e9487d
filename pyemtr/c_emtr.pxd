# Declares emtr.h to Cython; the header says what each item means.
from libc.stdint cimport int32_t, uint64_t

cdef extern from "emtr/emtr.h" nogil:
    ctypedef enum emtr_status:
        EMTR_OK
        EMTR_ERROR_ARGUMENT
        EMTR_ERROR_SETTING
        EMTR_ERROR_CLOUD
        EMTR_ERROR_MEMORY
        EMTR_ERROR_INTERNAL
        EMTR_ERROR_INTERRUPTED

    const char* emtr_status_text(emtr_status status)
    const char* emtr_error_message()
    ctypedef int (*emtr_interrupt_fn)(void* user) noexcept
    void emtr_set_interrupt(emtr_interrupt_fn interrupt, void* user)
    const char* emtr_version()
    const char* emtr_kernel_name()

    ctypedef struct emtr_settings:
        uint64_t seed
        int32_t has_guess
        double guess[16]
        int32_t has_viewpoint_source
        double viewpoint_source[3]
        int32_t has_viewpoint_target
        double viewpoint_target[3]
        int32_t has_axis
        double axis[3]
        int32_t has_translation_bounds
        double translation_minimum[3]
        double translation_maximum[3]
        const int32_t* correspondences
        size_t correspondence_count

    ctypedef enum emtr_setting_type:
        EMTR_SETTING_INTEGER
        EMTR_SETTING_REAL
        EMTR_SETTING_SWITCH
        EMTR_SETTING_CHOICE

    ctypedef struct emtr_setting_info:
        const char* name
        emtr_setting_type type
        const char* unit
        double minimum
        double maximum
        double value
        const char* part
        const char* text
        const char* choices

    emtr_status emtr_settings_init(emtr_settings* settings, size_t size, const char* preset)
    const char* emtr_preset_name(size_t index)
    size_t emtr_setting_count()
    emtr_status emtr_setting_describe(size_t index, emtr_setting_info* info, size_t size)
    emtr_status emtr_setting_set(emtr_settings* settings, const char* name, double value)
    emtr_status emtr_setting_get(const emtr_settings* settings, const char* name, double* value)

    ctypedef enum emtr_scalar:
        EMTR_FLOAT32
        EMTR_FLOAT64

    ctypedef struct emtr_cloud:
        const void* points
        size_t count
        size_t stride
        emtr_scalar scalar
        const void* normals
        size_t normal_stride
        const float* features
        size_t feature_dimension
        size_t feature_stride
        int32_t keep_points
        const float* colors
        size_t color_stride
        const float* intensities
        size_t intensity_stride

    ctypedef struct emtr_progress:
        const char* stage
        int32_t iteration
        int32_t iterations
        double best_alpha
        double best_beta

    ctypedef int (*emtr_progress_fn)(const emtr_progress* progress, void* user) noexcept

    ctypedef enum emtr_reason:
        pass

    const char* emtr_reason_name(emtr_reason reason)
    const char* emtr_reason_text(emtr_reason reason)

    ctypedef struct emtr_alternative:
        double transformation[16]
        double score
        double surface_fit
        double violation
        double evidence

    ctypedef struct emtr_result:
        pass

    void emtr_result_free(emtr_result* result)

    ctypedef enum emtr_field_type:
        EMTR_FIELD_REAL
        EMTR_FIELD_INT32
        EMTR_FIELD_SWITCH
        EMTR_FIELD_SIZE
        EMTR_FIELD_UINT64
        EMTR_FIELD_TEXT
        EMTR_FIELD_REASON
        EMTR_FIELD_ALTERNATIVE

    ctypedef struct emtr_result_field_info:
        const char* name
        const char* group
        const char* key
        emtr_field_type type
        size_t offset
        size_t rows
        size_t columns
        size_t count_offset

    size_t emtr_result_field_count()
    emtr_status emtr_result_field_describe(size_t index, emtr_result_field_info* info, size_t size)

    emtr_status emtr_residuals(const emtr_cloud* source, const emtr_cloud* target,
                               const double* transformation, int32_t threads,
                               double* of_source, double* of_target)

    ctypedef struct emtr_preprocessed:
        pass

    emtr_status emtr_preprocess(const emtr_cloud* cloud, const char* name, int32_t threads,
                                emtr_preprocessed** preprocessed)
    void emtr_preprocessed_free(emtr_preprocessed* preprocessed)

    ctypedef struct emtr_preprocessed_info:
        size_t points, dropped, base_points
        double center[3]
        double radius
        int32_t normals
        size_t keypoints, feature_dimension, strays

    emtr_status emtr_preprocessed_describe(const emtr_preprocessed* preprocessed,
                                           emtr_preprocessed_info* info, size_t size)
    emtr_status emtr_register_cached(const emtr_cloud* source, emtr_preprocessed** cached_source,
                                     const emtr_cloud* target, emtr_preprocessed** cached_target,
                                     const emtr_settings* settings, emtr_progress_fn progress,
                                     void* user, emtr_result** result)

    ctypedef struct emtr_problem:
        pass

    emtr_status emtr_problem_create(const emtr_cloud* source, const emtr_cloud* target,
                                    const emtr_settings* settings, emtr_problem** problem)
    emtr_status emtr_problem_create_preprocessed(const emtr_preprocessed* source,
                                                 const emtr_preprocessed* target,
                                                 const emtr_settings* settings,
                                                 emtr_problem** problem)
    void emtr_problem_free(emtr_problem* problem)
    emtr_status emtr_problem_solve(emtr_problem* problem, emtr_progress_fn progress, void* user,
                                   emtr_result** result)

    emtr_status emtr_problem_solve_from(emtr_problem* problem, const double* transformations,
                                        size_t count, emtr_progress_fn progress, void* user,
                                        emtr_result** result)
    emtr_status emtr_problem_score(const emtr_problem* problem, const double* transformations,
                                   size_t count, emtr_alternative* scored)
    emtr_status emtr_problem_refine(const emtr_problem* problem, const double* transformations,
                                    size_t count, double* refined)

    ctypedef enum emtr_resolution:
        EMTR_RESOLUTION_SPARSE
        EMTR_RESOLUTION_DENSE

    emtr_status emtr_task_alpha_evaluate(emtr_problem* problem, emtr_resolution resolution,
                                         const double* particles, size_t count, double* fitness)
    emtr_status emtr_task_beta_evaluate(emtr_problem* problem, const double* particles,
                                        size_t count, double* fitness)
    emtr_status emtr_complement(emtr_problem* problem, const double* angles, double* translation)
    emtr_status emtr_particle_to_transformation(const emtr_problem* problem,
                                                const double* particle, double* transformation)
    emtr_status emtr_transformation_to_particle(const emtr_problem* problem,
                                                const double* transformation, double* particle)
    uint64_t emtr_problem_queries(const emtr_problem* problem)

    ctypedef struct emtr_problem_info:
        double normalization_scale
        double center_source[3]
        double center_target[3]
        double leaf_sparse, leaf_dense, c_sparse, c_dense, tau
        size_t tims, tims_pruned

    emtr_status emtr_problem_describe(const emtr_problem* problem, emtr_problem_info* info,
                                      size_t size)

    ctypedef enum emtr_array:
        EMTR_SOURCE_SPARSE
        EMTR_TARGET_SPARSE
        EMTR_SOURCE_DENSE
        EMTR_TARGET_DENSE
        EMTR_SOURCE_NORMALS
        EMTR_TARGET_NORMALS
        EMTR_SOURCE_FEATURES
        EMTR_TARGET_FEATURES
        EMTR_CORRESPONDENCES
        EMTR_TIM_SOURCE
        EMTR_TIM_TARGET
        EMTR_SOURCE_FEATURE_POINTS
        EMTR_TARGET_FEATURE_POINTS
        EMTR_SOURCE_FEATURE_ROWS
        EMTR_TARGET_FEATURE_ROWS

    emtr_status emtr_problem_array(const emtr_problem* problem, emtr_array which,
                                   const void** data, size_t* rows, size_t* columns)
