# A numpy array seen as an emtr_cloud, without a copy.

@cython.final
cdef class CloudBuffer:
    """Holds the array's memory for as long as it lives. The package has seen to the layout:
    (n, 3), float32 or float64, x y z side by side, rows forward and not overlapping."""
    cdef Py_buffer view
    cdef bint held
    cdef emtr_cloud cloud

    def __init__(self, array):
        PyObject_GetBuffer(array, &self.view, PyBUF_STRIDES | PyBUF_FORMAT)
        self.held = True
        # The letter comes last; numpy puts a sign before it when the memory is unaligned.
        scalar = (<bytes>self.view.format)[-1:] if self.view.format != NULL else b""
        if self.view.ndim != 2 or self.view.shape[1] != 3 or scalar not in (b"f", b"d"):
            raise ValueError("a cloud of float32 or float64 with shape (n, 3) is expected")
        self.cloud.points = self.view.buf
        self.cloud.count = self.view.shape[0]
        self.cloud.scalar = EMTR_FLOAT32 if scalar == b"f" else EMTR_FLOAT64
        packed = 3 * self.view.itemsize
        if self.view.shape[0] <= 1:  # the stride of a single row means nothing
            self.cloud.stride = packed
        elif self.view.strides[0] < packed or self.view.strides[1] != self.view.itemsize:
            raise ValueError("a cloud with x, y, z side by side is expected")
        else:
            self.cloud.stride = self.view.strides[0]

    def __dealloc__(self):
        if self.held:
            PyBuffer_Release(&self.view)
