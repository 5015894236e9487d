# emtr_residuals: distances of one cloud's points to the other cloud.

def residuals(source, target, const double[::1] transformation, int threads, bint of_target,
              double[::1] out):
    """Writes the residuals of source or target into `out`; the transformation has 16 numbers."""
    cdef CloudBuffer a = CloudBuffer(source)
    cdef CloudBuffer b = CloudBuffer(target)
    cdef double* values = NULL
    cdef const double* pose
    cdef emtr_status status
    cdef Interrupt interrupt = Interrupt()
    cdef size_t count = b.cloud.count if of_target else a.cloud.count
    if transformation.shape[0] != 16 or <size_t>out.shape[0] != count:
        raise ValueError("16 numbers and room for a number a point are expected")
    if count == 0:
        return
    values, pose = &out[0], &transformation[0]
    interrupt.begin()
    with nogil:
        if of_target:
            status = emtr_residuals(&a.cloud, &b.cloud, pose, threads, NULL, values)
        else:
            status = emtr_residuals(&a.cloud, &b.cloud, pose, threads, values, NULL)
    interrupt.end(status)
