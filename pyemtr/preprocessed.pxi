# emtr_preprocessed: one cloud for many registrations.

@cython.final
cdef class Preprocessed:
    """Owns an emtr_preprocessed. It never changes, so any number of threads may use it."""
    cdef emtr_preprocessed* handle

    def __init__(self, CloudBuffer buffer not None, str name not None, int threads):
        cdef bytes text = name.encode()
        cdef const char* letters = text
        cdef emtr_preprocessed* made = NULL
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        if self.handle != NULL:
            raise RuntimeError("a cloud is preprocessed once")
        interrupt.begin()
        with nogil:
            status = emtr_preprocess(&buffer.cloud, letters, threads, &made)
        interrupt.end(status)
        self.handle = made

    def __dealloc__(self):
        emtr_preprocessed_free(self.handle)

    def describe(self):
        cdef emtr_preprocessed_info info
        check(emtr_preprocessed_describe(self.handle, &info, sizeof(info)))
        return {"points": info.points, "dropped": info.dropped, "base_points": info.base_points,
                "center": listed(info.center, 3), "radius": info.radius,
                "normals": bool(info.normals), "keypoints": info.keypoints,
                "feature_dimension": info.feature_dimension, "strays": info.strays}


cdef Preprocessed preprocessed(cloud, str name, Settings settings):
    """Returns a preprocessed cloud as it is; preprocesses a buffer now."""
    if isinstance(cloud, Preprocessed):
        return cloud
    return Preprocessed(cloud, name, <int>settings.get("threads"))
