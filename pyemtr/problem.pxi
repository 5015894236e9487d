# emtr_problem: the stages one by one.

ARRAYS = {
    "source_sparse": EMTR_SOURCE_SPARSE, "target_sparse": EMTR_TARGET_SPARSE,
    "source_dense": EMTR_SOURCE_DENSE, "target_dense": EMTR_TARGET_DENSE,
    "source_normals": EMTR_SOURCE_NORMALS, "target_normals": EMTR_TARGET_NORMALS,
    "source_features": EMTR_SOURCE_FEATURES, "target_features": EMTR_TARGET_FEATURES,
    "correspondences": EMTR_CORRESPONDENCES,
    "tim_source": EMTR_TIM_SOURCE, "tim_target": EMTR_TIM_TARGET,
    "source_feature_points": EMTR_SOURCE_FEATURE_POINTS,
    "target_feature_points": EMTR_TARGET_FEATURE_POINTS,
    "source_feature_rows": EMTR_SOURCE_FEATURE_ROWS,
    "target_feature_rows": EMTR_TARGET_FEATURE_ROWS}


@cython.final
cdef class Problem:
    """Owns an emtr_problem. The caller lets one thread in at a time."""
    cdef emtr_problem* problem

    def __init__(self, source, target, Settings settings not None):
        cdef CloudBuffer a
        cdef CloudBuffer b
        cdef Preprocessed c
        cdef Preprocessed d
        cdef emtr_settings* chosen = &settings.values
        cdef emtr_problem* made = NULL
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        if self.problem != NULL:
            raise RuntimeError("a problem is made once")
        if isinstance(source, Preprocessed) or isinstance(target, Preprocessed):
            c = preprocessed(source, "source", settings)
            d = preprocessed(target, "target", settings)
            interrupt.begin()
            with nogil:
                status = emtr_problem_create_preprocessed(c.handle, d.handle, chosen, &made)
        else:
            a, b = source, target
            interrupt.begin()
            with nogil:
                status = emtr_problem_create(&a.cloud, &b.cloud, chosen, &made)
        interrupt.end(status)
        self.problem = made

    def __dealloc__(self):
        emtr_problem_free(self.problem)

    def solve(self, callback):
        cdef Watch watch = Watch(callback)
        cdef emtr_result* result = NULL
        cdef emtr_status status
        cdef void* user = <void*>watch
        with nogil:
            status = emtr_problem_solve(self.problem, on_progress, user, &result)
        return finish(status, watch, result)

    def solve_from(self, const double[:, ::1] poses, callback):
        cdef Watch watch = Watch(callback)
        cdef emtr_result* result = NULL
        cdef emtr_status status
        cdef void* user = <void*>watch
        cdef size_t count = checked_poses(poses)
        cdef const double* values = &poses[0, 0]
        with nogil:
            status = emtr_problem_solve_from(self.problem, values, count, on_progress, user,
                                             &result)
        return finish(status, watch, result)

    def score(self, const double[:, ::1] poses):
        """Returns an alternative's values for each pose, in their order."""
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        cdef size_t count = checked_poses(poses)
        cdef const double* values = &poses[0, 0]
        cdef emtr_alternative* scored = <emtr_alternative*>malloc(count * sizeof(emtr_alternative))
        if scored == NULL:
            raise MemoryError("out of memory")
        try:
            interrupt.begin()
            with nogil:
                status = emtr_problem_score(self.problem, values, count, scored)
            interrupt.end(status)
            return [alternative(&scored[i]) for i in range(count)]
        finally:
            free(scored)

    def refine(self, const double[:, ::1] poses, double[:, ::1] refined):
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        cdef size_t count = checked_poses(poses)
        if checked_poses(refined) != count:
            raise ValueError("as many rows are expected")
        cdef const double* values = &poses[0, 0]
        cdef double* out = &refined[0, 0]
        interrupt.begin()
        with nogil:
            status = emtr_problem_refine(self.problem, values, count, out)
        interrupt.end(status)

    def evaluate_alpha(self, bint dense, const double[:, ::1] particles, double[::1] fitness):
        cdef size_t count = particles.shape[0]
        cdef emtr_resolution resolution = EMTR_RESOLUTION_DENSE if dense else EMTR_RESOLUTION_SPARSE
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        cdef const double* genes
        cdef double* values
        self.agree(particles, fitness, 6)
        if count:
            genes, values = &particles[0, 0], &fitness[0]
            interrupt.begin()
            with nogil:
                status = emtr_task_alpha_evaluate(self.problem, resolution, genes, count, values)
            interrupt.end(status)

    def evaluate_beta(self, const double[:, ::1] particles, double[::1] fitness):
        cdef size_t count = particles.shape[0]
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        cdef const double* genes
        cdef double* values
        self.agree(particles, fitness, 3)
        if count:
            genes, values = &particles[0, 0], &fitness[0]
            interrupt.begin()
            with nogil:
                status = emtr_task_beta_evaluate(self.problem, genes, count, values)
            interrupt.end(status)

    cdef int agree(self, const double[:, ::1] particles, double[::1] fitness, genes) except -1:
        if particles.shape[1] != genes or fitness.shape[0] != particles.shape[0]:
            raise ValueError(f"particles of {genes} genes and as many fitness values are expected")
        return 0

    def complement(self, double a, double b, double c):
        cdef double[3] angles = [a, b, c]
        cdef double[3] translation = [0, 0, 0]
        cdef emtr_status status
        with nogil:
            status = emtr_complement(self.problem, angles, translation)
        check(status)
        return listed(translation, 3)

    def to_transformation(self, const double[::1] particle):
        cdef double[16] transformation
        if particle.shape[0] != 6:
            raise ValueError("6 genes are expected")
        check(emtr_particle_to_transformation(self.problem, &particle[0], transformation))
        return listed(transformation, 16)

    def to_particle(self, const double[::1] transformation):
        cdef double[6] particle
        if transformation.shape[0] != 16:
            raise ValueError("16 numbers are expected")
        check(emtr_transformation_to_particle(self.problem, &transformation[0], particle))
        return listed(particle, 6)

    def queries(self):
        return emtr_problem_queries(self.problem)

    def describe(self):
        cdef emtr_problem_info info
        check(emtr_problem_describe(self.problem, &info, sizeof(info)))
        return {"normalization_scale": info.normalization_scale,
                "center_source": listed(info.center_source, 3),
                "center_target": listed(info.center_target, 3),
                "leaf_sparse": info.leaf_sparse, "leaf_dense": info.leaf_dense,
                "c_sparse": info.c_sparse, "c_dense": info.c_dense, "tau": info.tau,
                "tims": info.tims, "tims_pruned": info.tims_pruned}

    def array(self, str name not None):
        return ArrayView(self, name)


cdef size_t checked_poses(const double[:, ::1] poses) except 0:
    if poses.shape[0] == 0 or poses.shape[1] != 16:
        raise ValueError("poses of 16 numbers are expected, at least one")
    return poses.shape[0]


@cython.final
cdef class ArrayView:
    """One array of a problem by the buffer protocol, read-only; keeps the problem alive."""
    cdef Problem owner
    cdef const void* data
    cdef Py_ssize_t shape[2]
    cdef Py_ssize_t strides[2]
    cdef bint whole

    def __init__(self, Problem owner not None, str name not None):
        cdef size_t rows = 0
        cdef size_t columns = 0
        check(emtr_problem_array(owner.problem, ARRAYS[name], &self.data, &rows, &columns))
        self.owner = owner
        self.whole = name == "correspondences" or name.endswith("_rows")
        self.shape[0], self.shape[1] = rows, columns
        self.strides[0], self.strides[1] = 4 * columns, 4

    def __getbuffer__(self, Py_buffer* view, int flags):
        if flags & PyBUF_WRITABLE:
            raise BufferError("a problem's arrays are read-only")
        # An array without rows may have no memory; Python wants an address all the same.
        view.buf = <void*>self.data if self.data != NULL else <void*>self.shape
        view.obj = self
        view.len = 4 * self.shape[0] * self.shape[1]
        view.itemsize = 4
        view.readonly = 1
        view.format = NULL
        if flags & PyBUF_FORMAT:
            view.format = b"i" if self.whole else b"f"
        view.ndim = 2
        view.shape = self.shape if flags & PyBUF_ND else NULL
        view.strides = self.strides if (flags & PyBUF_STRIDES) == PyBUF_STRIDES else NULL
        view.suboffsets = NULL
        view.internal = NULL
