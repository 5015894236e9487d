# emtr_prepared: one cloud for many partners.

@cython.final
cdef class Prepared:
    """Owns an emtr_prepared, which never changes: any number of threads may use it."""
    cdef emtr_prepared* prepared

    def __init__(self, CloudBuffer buffer not None, str name not None, int threads):
        cdef bytes text = name.encode()
        cdef const char* letters = text
        cdef emtr_prepared* made = NULL
        cdef emtr_status status
        cdef Interrupt interrupt = Interrupt()
        if self.prepared != NULL:
            raise RuntimeError("a cloud is prepared once")
        interrupt.begin()
        with nogil:
            status = emtr_prepare(&buffer.cloud, letters, threads, &made)
        interrupt.end(status)
        self.prepared = made

    def __dealloc__(self):
        emtr_prepared_free(self.prepared)

    def describe(self):
        cdef emtr_prepared_info info
        check(emtr_prepared_describe(self.prepared, &info, sizeof(info)))
        return {"points": info.points, "dropped": info.dropped, "kept": info.kept,
                "center": listed(info.center, 3), "radius": info.radius,
                "normals": bool(info.normals), "described": info.described,
                "feature_dimension": info.feature_dimension}


cdef Prepared prepared(cloud, str name, Settings settings):
    """A prepared cloud as it is, a buffer prepared now."""
    if isinstance(cloud, Prepared):
        return cloud
    return Prepared(cloud, name, <int>settings.get("threads"))
