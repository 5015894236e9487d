# emtr_preprocessed: one cloud for many partners.

@cython.final
cdef class Preprocessed:
    """Owns an emtr_preprocessed, which never changes: any number of threads may use it."""
    cdef emtr_preprocessed* prepared

    def __init__(self, CloudBuffer buffer not None, str name not None, int threads):
        cdef bytes text = name.encode()
        cdef const char* letters = text
        cdef emtr_preprocessed* made = NULL
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        if self.prepared != NULL:
            raise RuntimeError("a cloud is prepared once")
        interrupt.begin()
        with nogil:
            status = emtr_preprocess(&buffer.cloud, letters, threads, &made)
        interrupt.end(status)
        self.prepared = made

    def __dealloc__(self):
        emtr_preprocessed_free(self.prepared)

    def describe(self):
        cdef emtr_preprocessed_info info
        check(emtr_preprocessed_describe(self.prepared, &info, sizeof(info)))
        return {"points": info.points, "dropped": info.dropped, "base_points": info.base_points,
                "center": listed(info.center, 3), "radius": info.radius,
                "normals": bool(info.normals), "keypoints": info.keypoints,
                "feature_dimension": info.feature_dimension}


cdef Preprocessed prepared(cloud, str name, Settings settings):
    """A prepared cloud as it is, a buffer prepared now."""
    if isinstance(cloud, Preprocessed):
        return cloud
    return Preprocessed(cloud, name, <int>settings.get("threads"))
